#include "engine/power/pole_finder.h"

#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "spatial/box.h"
#include "spatial/vector.h"

namespace stream_recon {

PoleIndex::PoleIndex(const ScratchDirectory& scratch, std::uint64_t pages)
    : file_(scratch.open(kPoleStore)), pages_(pages) {
  if (file_.record_count() >= kNoPole) {
    throw InputError("the cloud has more than 4294967294 poles; split it");
  }
  const PoleNumber step = std::max<PoleNumber>(1, count() / kSome);
  Box3 box;
  PoleNumber number = 0;
  RecordCursor<Pole> cursor(file_);
  std::vector<Pole> poles(file_.records_per_block());
  while (const std::size_t count = cursor.read(poles)) {
    first_.push_back(poles[0].tetrahedron);
    for (const Pole& pole : std::span(poles).first(count)) {
      range_.extend(site_of(pole));
      box.extend(pole.centre);
      if (number % step == 0) some_.push_back({number, pole});
      ++number;
    }
  }
  if (!box.empty()) reach_ = length(minus(box.high, box.low));
}

const PolePage& PoleFinder::page(std::uint64_t number) {
  if (number != number_) {
    pin_ = index_.pages_.get(number, [&](PolePage& page) {
      page.poles.resize(index_.file_.records_in_block(number));
      index_.file_.read_block(number, codec_, stored_,
                              std::as_writable_bytes(std::span(page.poles)));
    });
    number_ = number;
  }
  return *pin_;
}

const Pole& PoleFinder::pole(PoleNumber number) {
  const std::size_t a_block = index_.file_.records_per_block();
  return page(number / a_block).poles[number % a_block];
}

PoleNumber PoleFinder::first_not_below(const NodeKey& name) {
  const auto& first = index_.first_;
  const auto after = std::upper_bound(first.begin(), first.end(), name);
  if (after == first.begin()) return 0;
  const auto block = static_cast<std::uint64_t>(after - first.begin()) - 1;
  const std::vector<Pole>& poles = page(block).poles;
  const auto at =
      std::lower_bound(poles.begin(), poles.end(), name,
                       [](const Pole& pole, const NodeKey& key) { return pole.tetrahedron < key; });
  return static_cast<PoleNumber>(block * index_.file_.records_per_block() +
                                 static_cast<std::uint64_t>(at - poles.begin()));
}

PoleNumber PoleFinder::find(const NodeKey& name) {
  const PoleNumber number = first_not_below(name);
  return number < index_.count() && pole(number).tetrahedron == name ? number : kNoPole;
}

PoleNumber PoleFinder::lower_bound(std::uint32_t rank) {
  return first_not_below({{rank, 0, 0, 0}});
}

}  // namespace stream_recon
