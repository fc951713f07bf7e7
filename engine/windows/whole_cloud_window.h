// The one window that owns the whole cloud: its Delaunay tetrahedralization in core.
//
// Guarantees: view() is final, since nothing of the cloud is outside. The memory of the structure
// is reserved as long as this lives and returned to the system when it goes.
// Thread rule: built by one thread; the view is for many. Memory: about 330 bytes a point while it
// is built, 310 afterwards.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/budget.h"
#include "engine/stage_context.h"
#include "engine/windows/final_window.h"
#include "spatial/delaunay.h"

namespace stream_recon {

class WholeCloudWindow {
 public:
  /// Reads all points of the store.
  /// \param point_count of the store
  /// \param kept_free bytes of the budget that the window must leave to its consumers
  /// \throw BudgetError the cloud does not fit, with the least that would do
  /// \throw InputError the points have no tetrahedra: too few, or all in one plane
  WholeCloudWindow(std::uint64_t point_count, std::uint64_t kept_free, const StageContext& context);
  ~WholeCloudWindow();
  WholeCloudWindow(const WholeCloudWindow&) = delete;
  WholeCloudWindow& operator=(const WholeCloudWindow&) = delete;

  FinalWindow view() const;

 private:
  std::uint64_t point_count_;
  Reservation index_memory_;
  Reservation structure_memory_;
  std::vector<std::uint64_t> input_indices_;
  Delaunay delaunay_;
};

}  // namespace stream_recon
