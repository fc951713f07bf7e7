#include "engine/tetrahedra/tetrahedra_sink.h"

namespace stream_recon {

void TetrahedraSink::add(std::span<const TetrahedronRecord> tetrahedra) {
  const std::lock_guard lock(mutex_);
  for (const TetrahedronRecord& record : tetrahedra) {
    spool_.append(layout_.chunk_of(record.ranks[0]), record);
  }
}

}  // namespace stream_recon
