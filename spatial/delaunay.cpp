#include "spatial/delaunay.h"

#include "spatial/cell_view.h"
#include "spatial/incremental_kernel.h"

namespace stream_recon {

struct Delaunay::Impl : detail::IncrementalKernel<Point3> {
  using IncrementalKernel::IncrementalKernel;
};

Delaunay::Delaunay() : Delaunay(Options{}) {}
Delaunay::Delaunay(const Options& options) : impl_(std::make_unique<Impl>(options)) {}
Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

void Delaunay::set_max_bytes(std::size_t max_bytes) {
  impl_->set_max_bytes(max_bytes);
}

Delaunay::Outcome Delaunay::insert(std::span<const Point3> points) {
  return impl_->insert(points);
}

bool Delaunay::in_conflict(CellId c, const Point3& p) const {
  return impl_->in_conflict(c, p);
}

int Delaunay::dimension() const {
  return impl_->dimension();
}
std::size_t Delaunay::vertex_count() const {
  return impl_->site_count();
}
Point3 Delaunay::point(VertexId v) const {
  return view().point(v);
}

CellId Delaunay::cell_slots() const {
  return view().slots();
}
bool Delaunay::is_live(CellId c) const {
  return view().is_live(c);
}
bool Delaunay::is_infinite(CellId c) const {
  return view().is_infinite(c);
}
std::array<VertexId, 4> Delaunay::vertices(CellId c) const {
  return view().vertices(c);
}
CellId Delaunay::neighbor(CellId c, int i) const {
  return view().neighbor(c, i);
}
int Delaunay::mirror_index(CellId c, int i) const {
  return view().mirror_index(c, i);
}
CellView Delaunay::view() const {
  return impl_->view();
}

std::size_t Delaunay::finite_cell_count() const {
  return impl_->finite_cell_count();
}
std::size_t Delaunay::bytes() const {
  return impl_->bytes();
}

}  // namespace stream_recon
