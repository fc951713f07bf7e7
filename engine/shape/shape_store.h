// The faces of the power shape on disk: first those of each window, then all of them.
//
// Guarantees: the store is ascending and a function of the cloud alone; read while the scratch
// directory lasts. Thread rule: write_shape_window() is thread-safe, store_shape() has one caller.
// Memory: record_file_memory(kShapeBlock) a call. Layout: docs/formats.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/scratch_records.h"
#include "engine/shape/shape_records.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Name of the store (records of ShapeFace) in the scratch directory.
inline constexpr const char* kShapeStore = "shape";
inline constexpr std::string_view kShapePrefix = "shape";

inline constexpr std::size_t kShapeBlock = std::size_t{128} << 10;

using ShapeFile = RecordFile<ShapeFace>;

/// \param first_rank of the window's samples \throw IoError
void write_shape_window(ScratchDirectory& scratch, std::uint64_t first_rank,
                        std::span<const ShapeFace> faces);

/// Reads and removes the windows' files. \param first_ranks of all windows that were written
/// \throw IoError, BudgetError, Interrupted
void store_shape(std::vector<std::uint64_t> first_ranks, const StageContext& context);

}  // namespace stream_recon
