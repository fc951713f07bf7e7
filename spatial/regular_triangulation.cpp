#include "spatial/regular_triangulation.h"

#include "spatial/cell_view.h"
#include "spatial/incremental_kernel.h"

namespace stream_recon {

struct RegularTriangulation::Impl : detail::IncrementalKernel<WeightedPoint3> {
  using IncrementalKernel::IncrementalKernel;
};

RegularTriangulation::RegularTriangulation() : RegularTriangulation(Options{}) {}
RegularTriangulation::RegularTriangulation(const Options& options)
    : impl_(std::make_unique<Impl>(options)) {}
RegularTriangulation::~RegularTriangulation() = default;
RegularTriangulation::RegularTriangulation(RegularTriangulation&&) noexcept = default;
RegularTriangulation& RegularTriangulation::operator=(RegularTriangulation&&) noexcept = default;

void RegularTriangulation::set_max_bytes(std::size_t max_bytes) {
  impl_->set_max_bytes(max_bytes);
}

RegularTriangulation::Outcome RegularTriangulation::insert(std::span<const WeightedPoint3> sites) {
  return impl_->insert(sites);
}

bool RegularTriangulation::in_conflict(CellId c, const WeightedPoint3& site) const {
  return impl_->in_conflict(c, site);
}

int RegularTriangulation::dimension() const {
  return impl_->dimension();
}
std::size_t RegularTriangulation::site_count() const {
  return impl_->site_count();
}
WeightedPoint3 RegularTriangulation::site(VertexId v) const {
  return view().point(v);
}

bool RegularTriangulation::is_hidden(VertexId v) const {
  return impl_->is_hidden(v);
}
std::size_t RegularTriangulation::hidden_count() const {
  return impl_->hidden_count();
}

CellId RegularTriangulation::cell_slots() const {
  return view().slots();
}
bool RegularTriangulation::is_live(CellId c) const {
  return view().is_live(c);
}
bool RegularTriangulation::is_infinite(CellId c) const {
  return view().is_infinite(c);
}
std::array<VertexId, 4> RegularTriangulation::vertices(CellId c) const {
  return view().vertices(c);
}
CellId RegularTriangulation::neighbor(CellId c, int i) const {
  return view().neighbor(c, i);
}
int RegularTriangulation::mirror_index(CellId c, int i) const {
  return view().mirror_index(c, i);
}
WeightedCellView RegularTriangulation::view() const {
  return impl_->view();
}

std::size_t RegularTriangulation::finite_cell_count() const {
  return impl_->finite_cell_count();
}
std::size_t RegularTriangulation::bytes() const {
  return impl_->bytes();
}

}  // namespace stream_recon
