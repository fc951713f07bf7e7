#include "io/pvtp_writer.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/error.h"
#include "io/file.h"
#include "io/folder.h"
#include "io/rename_sequence.h"
#include "io/temporary_path.h"
#include "io/vtp_writer.h"

namespace stream_recon {
namespace {

constexpr std::string_view kEnding = ".pvtp";
constexpr std::string_view kChunkPrefix = "chunk_";
constexpr std::string_view kChunkEnding = ".vtp";

std::string chunk_name(std::uint64_t number) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%06llu", static_cast<unsigned long long>(number));
  return std::string(kChunkPrefix) + digits.data() + std::string(kChunkEnding);
}

bool is_chunk_name(std::string_view name) {
  if (!name.starts_with(kChunkPrefix) || !name.ends_with(kChunkEnding)) return false;
  name.remove_prefix(kChunkPrefix.size());
  name.remove_suffix(kChunkEnding.size());
  return name.size() >= 6 &&
         std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string folder_of(const std::string& index_path) {
  std::string folder = index_path.substr(0, index_path.size() - kEnding.size());
  if (folder.empty() || folder.ends_with('/')) {
    throw std::invalid_argument("'" + index_path + "' lacks a name before .pvtp");
  }
  return folder;
}

/// Replacing the folder removes what is in it, so nothing but chunks may be.
void require_replaceable(const std::string& folder) {
  if (!path_exists(folder)) return;
  const bool is_plain_folder = is_folder(folder) && !std::filesystem::is_symlink(folder);
  const auto names = is_plain_folder ? list_folder(folder) : std::vector<std::string>{""};
  const auto foreign = std::find_if_not(names.begin(), names.end(), is_chunk_name);
  if (foreign == names.end()) return;
  throw IoError("cannot replace " + folder + (is_plain_folder ? ": it holds " + *foreign : "") +
                ", which is no chunk of a surface; move it or choose another name for the output");
}

TemporaryPath make_staging_folder(const std::string& folder) {
  require_replaceable(folder);
  const std::string path = temporary_name_beside(folder);
  make_folder(path);
  return {path, TemporaryPath::Kind::kFolder};
}

std::string escape_xml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

class PvtpWriter final : public SurfaceWriter {
 public:
  explicit PvtpWriter(const SurfaceWriterOptions& options)
      : index_path_(options.path),
        folder_(folder_of(options.path)),
        scalar_(options.coordinates),
        staging_(make_staging_folder(folder_)),
        chunk_writer_(options.coordinates) {
    if (is_folder(index_path_)) throw_system_error("write", index_path_, EISDIR);
  }

  void write(const SurfaceChunk& chunk) override;
  void finish() override;
  std::uint64_t bytes_written() const override { return bytes_written_; }

 private:
  std::string index_text() const;
  void sync_chunks() const;
  void publish(TemporaryPath& index);

  std::string index_path_;
  std::string folder_;
  Scalar scalar_;
  TemporaryPath staging_;
  VtpWriter chunk_writer_;
  std::uint64_t chunk_count_ = 0;
  std::uint64_t bytes_written_ = 0;
};

void PvtpWriter::write(const SurfaceChunk& chunk) {
  File file = File::create(staging_.path() + "/" + chunk_name(chunk_count_));
  chunk_writer_.write(chunk, file);
  bytes_written_ += file.position();
  file.close();
  ++chunk_count_;
}

std::string PvtpWriter::index_text() const {
  const std::string folder = escape_xml(std::filesystem::path(folder_).filename().string());
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PPolyData\" " + std::string(kVtkXmlAttributes) +
      ">\n<PPolyData GhostLevel=\"0\">\n"
      "<PPointData GlobalIds=\"GlobalPointId\">\n"
      "<PDataArray type=\"Int64\" IdType=\"1\" Name=\"GlobalPointId\"/>\n"
      "</PPointData>\n<PCellData Scalars=\"Delta\">\n"
      "<PDataArray type=\"Float32\" Name=\"Delta\"/>\n"
      "<PDataArray type=\"UInt8\" Name=\"Source\"/>\n"
      "</PCellData>\n<PPoints>\n<PDataArray type=\"" +
      vtk_type(scalar_) + "\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
  for (std::uint64_t i = 0; i < chunk_count_; ++i) {
    text += "<Piece Source=\"" + folder + "/" + chunk_name(i) + "\"/>\n";
  }
  return text + "</PPolyData>\n</VTKFile>\n";
}

void PvtpWriter::sync_chunks() const {
  // All at the end: by then the system has written most of them, and the first call the journal.
  for (std::uint64_t i = 0; i < chunk_count_; ++i) {
    File::open(staging_.path() + "/" + chunk_name(i)).sync();
  }
  sync_parent_folder(staging_.path() + "/" + chunk_name(0));
}

void PvtpWriter::finish() {
  if (chunk_count_ == 0) write({});  // readers expect a piece, even an empty one
  sync_chunks();
  const std::string text = index_text();
  File file = File::create(temporary_name_beside(index_path_));
  TemporaryPath index(file.path(), TemporaryPath::Kind::kFile);
  file.write(std::as_bytes(std::span(text)));
  file.sync();
  file.close();
  publish(index);
  bytes_written_ += text.size();
}

void PvtpWriter::publish(TemporaryPath& index) {
  require_replaceable(folder_);
  const std::string old_index = temporary_name_beside(index_path_);
  const std::string old_folder = temporary_name_beside(folder_);
  RenameSequence renames;
  if (path_exists(index_path_)) renames.rename(index_path_, old_index);
  if (path_exists(folder_)) renames.rename(folder_, old_folder);
  renames.rename(staging_.path(), folder_);
  renames.rename(index.path(), index_path_);
  sync_parent_folder(index_path_);
  renames.commit();
  staging_.keep();
  index.keep();
  remove_file(old_index.c_str());
  remove_folder(old_folder.c_str());
}

}  // namespace

std::unique_ptr<SurfaceWriter> make_pvtp_writer(const SurfaceWriterOptions& options) {
  return std::make_unique<PvtpWriter>(options);
}

}  // namespace stream_recon
