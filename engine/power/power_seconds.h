// Processor time of the windows of the power diagram, by what it went into. Thread rule: a value.
#pragma once

namespace stream_recon {

struct PowerSeconds {
  double samples = 0;   ///< their windows
  double touching = 0;  ///< the poles that touch what owned ones touch
  double insert = 0;
  double walk = 0;
  double prove = 0;  ///< samples' tetrahedra that walks came by
  double faces = 0;

  void add(const PowerSeconds& other) {
    samples += other.samples;
    touching += other.touching;
    insert += other.insert;
    walk += other.walk;
    prove += other.prove;
    faces += other.faces;
  }
};

}  // namespace stream_recon
