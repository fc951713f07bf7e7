#include "engine/restart/open_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "engine/restart/artefact_check.h"
#include "engine/restart/run_identity.h"
#include "engine/restart/run_journal.h"
#include "io/folder.h"

namespace stream_recon {
namespace {

constexpr auto kGrace = std::chrono::seconds(3);
constexpr auto kPoll = std::chrono::milliseconds(20);

struct DeadRun {
  AbandonedScratch scratch;
  Manifest manifest;
};

std::string manifest_path(const std::string& scratch) {
  return scratch + "/" + kManifest;
}

/// Nothing if it is damaged, or gone in the meantime.
std::optional<Manifest> manifest_in(const std::string& scratch) {
  try {
    File file = File::open(manifest_path(scratch));
    std::string text(file.size(), '\0');
    text.resize(file.read(std::as_writable_bytes(std::span(text))));
    return manifest_from_text(text);
  } catch (const IoError&) {
    return std::nullopt;
  }
}

class RunOpener {
 public:
  RunOpener(const RunOptions& options, RunIdentity identity)
      : options_(options),
        identity_(std::move(identity)),
        scratch_options_{options.scratch_parent(), options.scratch_limit_bytes} {}

  OpenedRun open() {
    std::vector<DeadRun> dead = dead_runs();
    const auto best =
        std::max_element(dead.begin(), dead.end(), [](const DeadRun& a, const DeadRun& b) {
          return a.manifest.windows.done_points() < b.manifest.windows.done_points();
        });
    std::optional<DeadRun> resumed;
    if (options_.resume && best != dead.end()) {
      require_same(best->manifest);
      resumed = std::move(*best);
      dead.erase(best);
    }
    for (const DeadRun& run : dead) remove(run);
    if (resumed) return go_on(std::move(*resumed));
    if (options_.resume) {
      options_.say(fmt::format("nothing to resume in {}: starting from the beginning",
                               scratch_options_.parent));
    }
    return begin();
  }

 private:
  OpenedRun begin() const {
    OpenedRun opened;
    opened.scratch = std::make_unique<ScratchDirectory>(scratch_options_);
    opened.manifest.identity = identity_;
    return opened;
  }

  /// Those with our outputs.
  std::vector<DeadRun> dead_runs() const {
    std::vector<DeadRun> dead;
    for (const std::string& path : scratch_folders(scratch_options_.parent)) {
      auto lock = FolderLock::try_take(path);
      if (!lock && writes_files(identity_) && is_ours(manifest_in(path))) lock = wait_for_end(path);
      if (!lock) continue;
      if (!path_exists(manifest_path(path))) {
        remove_folder(path.c_str());
        continue;
      }
      auto manifest = manifest_in(path);
      if (!manifest) {
        options_.say(
            fmt::format("{} is damaged or of another version and left alone; remove it "
                        "unless that version is to go on with it",
                        path));
      } else if (is_ours(manifest)) {
        dead.push_back({{path, std::move(*lock)}, std::move(*manifest)});
      }
    }
    return dead;
  }

  bool is_ours(const std::optional<Manifest>& manifest) const {
    return manifest && have_same_outputs(manifest->identity, identity_);
  }

  /// A process that was killed lives on until its memory is given back. Nothing if it ended well.
  static std::optional<FolderLock> wait_for_end(const std::string& path) {
    const auto deadline = std::chrono::steady_clock::now() + kGrace;
    while (path_exists(path)) {
      if (auto lock = FolderLock::try_take(path)) return lock;
      if (std::chrono::steady_clock::now() > deadline) {
        throw IoError(
            fmt::format("another run that writes the same output is under way in {}; wait for its "
                        "end, or give another output",
                        path));
      }
      std::this_thread::sleep_for(kPoll);
    }
    return std::nullopt;
  }

  void require_same(const Manifest& manifest) const {
    const auto differs = difference(manifest.identity, identity_);
    if (!differs) return;
    const std::string message = fmt::format(
        "cannot resume: {}; give the same again, or leave --resume out to start anew", *differs);
    if (differs->starts_with("input ")) throw InputError(message);
    throw std::invalid_argument(message);
  }

  void remove_left_outputs(const std::string& scratch_path) const {
    for (const std::string& output :
         {options_.output, options_.tetrahedra, options_.unused, options_.medial_axis}) {
      if (output.empty() || output == "-") continue;
      remove_left_beside(output, scratch_path);
      if (!output.ends_with(".pvtp") && !output.ends_with(".pvtu")) continue;
      remove_left_beside(std::filesystem::path(output).replace_extension(), scratch_path);
    }
  }

  void remove(const DeadRun& run) const {
    const std::string& path = run.scratch.path;
    if (!writes_files(identity_) && run.manifest.order) {
      options_.say(
          fmt::format("an unfinished run lies in {}: go on with --resume, or remove it", path));
      return;
    }
    remove_left_outputs(path);
    remove_file(manifest_path(path).c_str());
    remove_folder(path.c_str());
    if (!run.manifest.order) return;
    options_.say(
        fmt::format("removed what an unfinished run had left in {}; with --resume it would "
                    "have gone on",
                    path));
  }

  OpenedRun go_on(DeadRun run) const {
    remove_left_outputs(run.scratch.path);
    OpenedRun opened;
    opened.scratch = std::make_unique<ScratchDirectory>(std::move(run.scratch), scratch_options_);
    opened.manifest = std::move(run.manifest);
    const std::string redone = keep_intact_artefacts(opened.manifest, *opened.scratch);
    if (!redone.empty()) {
      options_.say(
          fmt::format("the scratch files of the unfinished run are damaged: {} must be done "
                      "again",
                      redone));
    }
    return opened;
  }

  const RunOptions& options_;
  const RunIdentity identity_;
  const ScratchOptions scratch_options_;
};

}  // namespace

OpenedRun open_run(const RunOptions& options, RunIdentity identity) {
  return RunOpener(options, std::move(identity)).open();
}

}  // namespace stream_recon
