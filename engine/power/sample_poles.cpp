#include "engine/power/sample_poles.h"

#include <algorithm>
#include <numeric>

#include "spatial/cell_view.h"

namespace stream_recon {

NodeKey SamplePoles::name_of(CellId cell) const {
  const FinalWindow window = samples_.view();
  const auto v = window.delaunay().view().vertices(cell);
  NodeKey name;
  for (int i = 0; i < 4; ++i) name.ranks[i] = static_cast<std::uint32_t>(window.rank(v[i]));
  std::sort(name.ranks.begin(), name.ranks.end());
  return name;
}

void SamplePoles::add(PoleNumber number, const Pole& pole, CellId cell) {
  entries_.push_back({number, cell, pole.tetrahedron, pole.is_inside != 0});
  added_.push_back(site_of(pole));
}

void SamplePoles::add_owned(const OwnedRange& owned, const SampleChoice* choice) {
  const PoleNumber begin = finder_.lower_bound(static_cast<std::uint32_t>(owned.first));
  const PoleNumber end = finder_.lower_bound(static_cast<std::uint32_t>(owned.end()));
  for (PoleNumber number = begin; number < end; ++number) {
    const Pole& pole = finder_.pole(number);
    const bool is_wanted = choice == nullptr || choice->has_corner_of(pole.tetrahedron);
    if (pole.is_inside != 0 && is_wanted) add(number, pole, kNoCell);
  }
  owned_count_ = count();
  find_cells_of_owned(owned);
}

// All tetrahedra of owned samples are final, so that every owned pole meets its cell.
void SamplePoles::find_cells_of_owned(const OwnedRange& owned) {
  std::vector<VertexId> first(owned.count + 1);  // entry of a lowest sample
  for (VertexId entry = 0; entry < owned_count_; ++entry) {
    ++first[entries_[entry].name.ranks[0] - owned.first + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  const CellView cells = samples_.view().delaunay().view();
  states_.assign(cells.slots(), State::kUnknown);
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!samples_.is_final(cell) || cells.is_infinite(cell)) continue;
    const NodeKey name = name_of(cell);
    if (name.ranks[0] < owned.first || name.ranks[0] >= owned.end()) continue;
    const std::uint64_t lowest = name.ranks[0] - owned.first;
    for (VertexId entry = first[lowest]; entry < first[lowest + 1]; ++entry) {
      if (entries_[entry].name != name) continue;
      entries_[entry].cell = cell;
      states_[cell] = State::kAdded;
    }
  }
}

void SamplePoles::add_some(std::span<const NumberedPole> some) {
  std::vector<PoleNumber> here;
  here.reserve(entries_.size());
  for (const Entry& entry : entries_) here.push_back(entry.number);
  std::sort(here.begin(), here.end());
  for (const NumberedPole& pole : some) {
    if (std::binary_search(here.begin(), here.end(), pole.number)) continue;
    loose_.push_back(pole.number);
    add(pole.number, pole.pole, kNoCell);
  }
}

SamplePoles::State SamplePoles::state(CellId cell) {
  if (cell >= states_.size()) states_.resize(samples_.view().delaunay().view().slots());
  State& state = states_[cell];
  if (state == State::kUnknown) {
    const PoleNumber number = finder_.find(name_of(cell));
    if (number == kNoPole) {
      state = State::kNotAPole;
    } else {
      const bool is_loose = std::binary_search(loose_.begin(), loose_.end(), number);
      state = is_loose ? State::kInserted : State::kMissing;
    }
  }
  return state;
}

void SamplePoles::add_missing(CellId cell) {
  if (state(cell) != State::kMissing) return;
  const PoleNumber number = finder_.find(name_of(cell));
  add(number, finder_.pole(number), cell);
  states_[cell] = State::kAdded;
}

std::vector<WeightedPoint3> SamplePoles::take_added() {
  for (std::size_t v = entries_.size() - added_.size(); v < entries_.size(); ++v) {
    if (entries_[v].cell != kNoCell) states_[entries_[v].cell] = State::kInserted;
  }
  return std::exchange(added_, {});
}

std::optional<VertexId> SamplePoles::common_sample(std::span<const VertexId> poles) const {
  const auto known = std::find_if(poles.begin(), poles.end(),
                                  [this](VertexId pole) { return entries_[pole].cell != kNoCell; });
  if (known == poles.end()) return std::nullopt;
  const FinalWindow window = samples_.view();
  std::optional<VertexId> lowest;
  for (const VertexId sample : window.delaunay().view().vertices(entries_[*known].cell)) {
    if (lowest && window.rank(*lowest) < window.rank(sample)) continue;
    const auto rank = static_cast<std::uint32_t>(window.rank(sample));
    const bool is_common = std::all_of(poles.begin(), poles.end(), [&](VertexId pole) {
      const auto& ranks = entries_[pole].name.ranks;
      return ranks[0] == rank || ranks[1] == rank || ranks[2] == rank || ranks[3] == rank;
    });
    if (is_common) lowest = sample;
  }
  return lowest;
}

std::uint64_t SamplePoles::bytes() const {
  return entries_.capacity() * sizeof(Entry) + added_.capacity() * sizeof(WeightedPoint3) +
         states_.capacity() + loose_.capacity() * sizeof(PoleNumber);
}

}  // namespace stream_recon
