#include "tools/slices/volume_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/error.h"
#include "io/folder.h"
#include "tools/slices/dicom_header.h"
#include "tools/slices/slice_names.h"

namespace stream_recon {
namespace {

using Names = std::vector<std::string>;

std::string joined(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

Names visible_files(const std::string& folder) {
  Names names;
  for (const std::string& name : list_folder(folder))
    if (!name.starts_with('.') && std::filesystem::is_regular_file(joined(folder, name)))
      names.push_back(name);
  sort_naturally(names);
  return names;
}

Names joined_all(const std::string& folder, const Names& names) {
  Names paths;
  for (const std::string& name : names) paths.push_back(joined(folder, name));
  return paths;
}

struct Sorted {
  Names images, dicom, others;
};

Sorted sorted_by_kind(const std::string& folder) {
  Sorted files;
  for (const std::string& name : visible_files(folder)) {
    const std::string path = joined(folder, name);
    const bool is_image = is_named_as_image(name) || image_kind_of(path);
    (is_image ? files.images : is_dicom(path) ? files.dicom : files.others).push_back(name);
  }
  return files;
}

/// A slice that was cut off within its first bytes is no longer known by them.
void refuse_unknown_slices(const std::string& folder, const Names& slices, const Names& others) {
  std::set<std::string> shapes;
  for (const std::string& name : slices) shapes.insert(shape_of_name(name));
  for (const std::string& name : others) {
    if (!shapes.contains(shape_of_name(name))) continue;
    throw InputError(
        fmt::format("{}: named like the slices, but not one of them, or cut off; copy "
                    "it again, or move it away",
                    joined(folder, name)));
  }
}

ImageKind common_kind(const std::string& folder, const Names& images) {
  std::optional<ImageKind> common;
  for (const std::string& name : images) {
    const std::string path = joined(folder, name);
    const auto kind = image_kind_of(path);
    if (!kind) refuse_unknown_image(path);
    if (!common) common = kind;
    if (kind == common) continue;
    throw InputError(fmt::format("{}: {} ({}) and {} ({}) in one folder; leave one kind there",
                                 folder, images.front(), name_of(*common), name, name_of(*kind)));
  }
  return *common;
}

}  // namespace

FolderSlices slices_in_folder(const std::string& folder) {
  const Sorted files = sorted_by_kind(folder);
  if (!files.dicom.empty() && files.dicom.size() >= files.images.size()) {
    refuse_unknown_slices(folder, files.dicom, files.others);
    return {joined_all(folder, files.dicom), {}};
  }
  if (files.images.empty()) {
    throw InputError(
        fmt::format("{}: no PNG, TIFF, JPEG, BMP or DICOM slices in this folder; name "
                    "a single volume file",
                    folder));
  }
  if (!files.dicom.empty()) {
    throw InputError(fmt::format("{}: {} (DICOM) among images such as {}; leave one kind there",
                                 folder, files.dicom.front(), files.images.front()));
  }
  const ImageKind kind = common_kind(folder, files.images);
  refuse_unknown_slices(folder, files.images, files.others);
  check_numbered_row(folder, files.images);
  return {joined_all(folder, files.images), kind};
}

std::vector<std::string> raw_files_in_folder(const std::string& folder) {
  static const std::set<std::string> kTexts{".txt", ".md",  ".nhdr", ".mhd",
                                            ".hdr", ".xml", ".json", ".csv"};
  Names names = visible_files(folder);
  std::erase_if(names, [](const std::string& name) {
    return kTexts.contains(lower_ending(name)) || name.starts_with("README");
  });
  if (names.empty())
    throw InputError(fmt::format("{}: no files with voxels in this folder", folder));
  check_numbered_row(folder, names);
  return joined_all(folder, names);
}

}  // namespace stream_recon
