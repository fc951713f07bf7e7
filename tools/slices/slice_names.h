// The order of slices by their names, and whether one of them is missing.
//
// Guarantees: numbers within names count as numbers (slice_2 before slice_10), whatever their
// leading zeros. Thread rule: stateless.
#pragma once

#include <string>
#include <vector>

namespace stream_recon {

/// Sorts names naturally: runs of digits by their value, all else by its bytes.
void sort_naturally(std::vector<std::string>& names);

/// The name with a # for each run of digits.
std::string shape_of_name(const std::string& name);

/// Of naturally sorted names that differ in one number only: each number must stand once, and none
/// may be missing. A row in even steps (1, 6, 11, 16) is complete. Other names are not checked.
/// \throw InputError `folder` lacks a number or has one twice
void check_numbered_row(const std::string& folder, const std::vector<std::string>& names);

}  // namespace stream_recon
