// One window of the power diagram: the regular triangulation of the poles inside the body whose
// lowest sample is owned, and of as many others as it takes to prove every star of these final.
//
// A pole is the ball of a Delaunay tetrahedron of the samples. It is closer than orthogonal to a
// sphere (z, w) iff that tetrahedron is in conflict with the weighted point (z, w), and what is in
// conflict is connected and next to the sphere's own four poles. So certificates are found by
// walking through the tetrahedra of the samples, which are proved final where a walk comes by.
// Guarantees: after build() returned kDone, no pole of the cloud is in conflict with a cell of the
// triangulation that has an owned pole, so that these are cells of the regular triangulation of all
// poles; windows that own all samples own every pole inside, each once.
// Thread rule: one thread. Memory: bytes(): the samples' window, 1 byte a tetrahedron of it more,
// and about 1 KB an owned pole. Cost: 50 to 80 us an owned pole, in 16 walks of 33 tests each; two
// thirds of it walking. Source: docs/algorithms/weighted.md
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/power/ball_walk.h"
#include "engine/power/power_seconds.h"
#include "engine/power/sample_poles.h"
#include "engine/windows/certified_window.h"
#include "spatial/orthosphere.h"
#include "spatial/regular_triangulation.h"

namespace stream_recon {

struct PowerCounts {
  std::uint64_t owned = 0;   ///< poles
  std::uint64_t guests = 0;  ///< other poles in the diagram
  std::uint64_t rounds = 0;
  std::uint64_t walks = 0;  ///< one for each cell asked about, and for each sample closed
  std::uint64_t tests = 0;  ///< of a tetrahedron against the sphere of a cell
  PowerSeconds seconds;

  void add(const PowerCounts& other);
};

class PowerWindow {
 public:
  using Outcome = CertifiedWindow::Outcome;

  /// \pre All outlive the window.
  PowerWindow(CertifiedWindow& samples, const PoleIndex& index, PoleFinder& finder);

  /// \param memory_bytes for the samples' window as well
  /// \param choice owned poles are those that touch one of these; null: all
  /// \return kOutgrown: the memory does not hold it; build it anew for fewer samples
  /// \pre The samples' window has been built for `owned` with whole stars. Called once.
  /// \throw IoError, Interrupted; InputError balls whose sizes exact arithmetic cannot hold
  Outcome build(const OwnedRange& owned, std::uint64_t memory_bytes,
                const SampleChoice* choice = nullptr);

  /// Gives back what only build() needs.
  void forget_walks() { walk_.reset(); }

  const CertifiedWindow& samples() const { return samples_; }
  /// By vertex of triangulation(), owned ones first.
  const SamplePoles& poles() const { return poles_; }
  const RegularTriangulation& triangulation() const { return power_; }
  const PowerCounts& counts() const { return counts_; }
  /// Held now, with the window of samples, bytes.
  std::uint64_t bytes() const;

 private:
  struct Question;

  bool close_owned();
  bool prove();
  bool insert_added();
  void ask_all();
  void ask(std::span<const CellId> cells);
  Question question(CellId cell) const;
  void answer(const Question& question);
  void walk(const Question& question);
  bool close(VertexId sample, CellId start);
  bool is_closer(const Question& question, CellId cell);
  bool is_seen(const Question& question, CellId infinite) const;

  CertifiedWindow& samples_;
  SamplePoles poles_;
  std::optional<BallWalk> walk_;
  std::span<const NumberedPole> some_;
  OrthosphereReach reach_;
  double tie_error_ = 0;  ///< balls whose power to a sample is smaller count as touching it
  std::uint64_t memory_bytes_ = 0;
  RegularTriangulation power_;
  std::vector<bool> done_;  ///< cells of the power diagram without conflict
  /// Of samples: the round since which all poles that touch it are there; 0 if that is not known.
  std::vector<std::uint32_t> closed_;
  std::vector<CellId> unproven_;
  PowerCounts counts_;
};

}  // namespace stream_recon
