// Points of a text: one a line, x y z in the first three columns or in columns named so.
//
// What is read:
// - columns between blanks or tabs, or between commas or semicolons (one kind a file, blanks around
//   them allowed); further columns are ignored; "nan" and "inf" are numbers;
// - comments from "#" or "//" on, and empty lines, anywhere; a byte order mark;
// - names of the columns in the first line, or in the comment right before the first point if it
//   names as many columns as the point has: then x, y and z are found by name;
// - a count alone in the first line (.pts files): then exactly that many points must follow.
// Anything else is refused with its line: letters where a number should be (as in the .xyz files of
// chemistry), decimal commas, fewer columns than three.
//
// Without a count a text that is cut at a line end, or inside the very last number, cannot be told
// from a whole one; a last line with fewer columns than the first is refused.
// Memory: the source's window. Cost: about 0.2 us a point.
#pragma once

#include <memory>

#include "io/byte_source.h"
#include "io/point_source.h"

namespace stream_recon {

/// \throw InputError no points can be read from the first lines; IoError
std::unique_ptr<PointSource> make_xyz_source(std::unique_ptr<ByteSource> source);

}  // namespace stream_recon
