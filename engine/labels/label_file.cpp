#include "engine/labels/label_file.h"

#include <cassert>
#include <utility>

#include "io/error.h"

namespace stream_recon {

LabelFile::LabelFile(std::string name, std::uint64_t tables, const StageContext& context)
    : scratch_(context.scratch),
      budget_(context.budget),
      name_(std::move(name)),
      memory_(context.budget.reserve(tables * sizeof(Table) + writing_memory(),
                                     "labels of tetrahedra on disk")) {
  tables_.reserve(tables);
  writer_.emplace(create_records<std::uint64_t>(scratch_, name_, kBlock));
}

LabelFile::~LabelFile() {
  writer_.reset();
  file_.reset();
  scratch_.remove(name_);
}

void LabelFile::begin_table(std::uint64_t nodes) {
  assert(tables_.size() < tables_.capacity());
  assert(tables_.empty() || appended_ == tables_.back().nodes);
  tables_.push_back({.nodes = nodes, .first_word = writer_->record_count()});
  appended_ = 0;
}

void LabelFile::append(NodeLabel label) {
  if (label == NodeLabel::kUnattached) ++unattached_;
  word_ |= static_cast<std::uint64_t>(label) << appended_ % NodeLabels::kNodesAWord * 2;
  ++appended_;
  if (appended_ % NodeLabels::kNodesAWord == 0 || appended_ == tables_.back().nodes) {
    writer_->append(word_);
    word_ = 0;
  }
}

void LabelFile::finish() {
  writer_->finish();
  writer_.reset();
  memory_.resize(tables_.size() * sizeof(Table));
  file_.emplace(scratch_.open(name_));
}

NodeLabels LabelFile::labels(std::uint64_t table) const {
  constexpr const char* kHolder = "labels of tetrahedra";
  const Table& place = tables_[table];
  NodeLabels labels(place.nodes, budget_.reserve(NodeLabels::memory(place.nodes), kHolder));
  const Reservation reading = budget_.reserve(reading_memory(), kHolder);
  RecordCursor<std::uint64_t> cursor(*file_);
  cursor.seek(place.first_word);
  if (cursor.read(labels.words()) != labels.words().size()) {
    throw IoError("the scratch file " + name_ + " is too short; check the disk and run again");
  }
  return labels;
}

}  // namespace stream_recon
