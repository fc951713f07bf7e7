#include "tests/benchmarks/pole_links.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

namespace stream_recon {
namespace {

struct End {
  std::uint32_t pole;
  double weight;
  bool is_opposite;
};

/// The links of each pole.
class Ends {
 public:
  Ends(std::uint32_t poles, std::span<const PoleLink> links) : first_(poles + 1), ends_() {
    for (const PoleLink& link : links) ++first_[link.a + 1], ++first_[link.b + 1];
    for (std::uint32_t p = 0; p < poles; ++p) first_[p + 1] += first_[p];
    ends_.resize(first_[poles]);
    std::vector<std::size_t> next = first_;
    for (const PoleLink& link : links) {
      ends_[next[link.a]++] = {link.b, link.weight, link.is_opposite};
      ends_[next[link.b]++] = {link.a, link.weight, link.is_opposite};
    }
  }
  std::span<const End> of(std::uint32_t pole) const {
    return std::span(ends_).subspan(first_[pole], first_[pole + 1] - first_[pole]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<End> ends_;
};

class Spreading {
 public:
  Spreading(std::uint32_t poles, std::span<const PoleLink> links)
      : ends_(poles, links), poles_(poles), labels_(poles, LinkLabel::kNone) {}

  std::vector<LinkLabel> run(std::span<const std::uint32_t> outside) {
    for (const std::uint32_t pole : outside) raise(pole, false, 1);
    while (!queue_.empty()) {
      const Waiting next = queue_.top();
      queue_.pop();
      // Others of this pole are in the queue where its values have changed.
      if (labels_[next.pole] == LinkLabel::kNone && next.sureness == sureness(next.pole))
        settle(next.pole);
    }
    return std::move(labels_);
  }

 private:
  struct Values {
    double inside = 0;
    double outside = 0;
  };
  struct Waiting {
    double sureness;
    std::uint32_t pole;
    bool operator<(const Waiting& other) const {
      return sureness != other.sureness ? sureness < other.sureness : pole > other.pole;
    }
  };

  double sureness(std::uint32_t pole) const {
    const auto [inside, outside] = poles_[pole];
    if (inside == 0 || outside == 0) return std::max(inside, outside);
    return std::abs(inside - outside) - 1;
  }

  void raise(std::uint32_t pole, bool is_inside, double value) {
    double& old = is_inside ? poles_[pole].inside : poles_[pole].outside;
    if (labels_[pole] != LinkLabel::kNone || value <= old) return;
    old = value;
    queue_.push({sureness(pole), pole});
  }

  void settle(std::uint32_t pole) {
    const auto [inside, outside] = poles_[pole];
    const bool is_inside = inside > outside;
    labels_[pole] = is_inside ? LinkLabel::kInside : LinkLabel::kOutside;
    for (const End& end : ends_.of(pole))
      raise(end.pole, is_inside != end.is_opposite, std::max(inside, outside) * end.weight);
  }

  Ends ends_;
  std::vector<Values> poles_;
  std::vector<LinkLabel> labels_;
  std::priority_queue<Waiting> queue_;
};

/// Components of poles, each pole with its sign relative to the root.
class Signs {
 public:
  explicit Signs(std::uint32_t nodes) : up_(nodes), is_turned_(nodes, 0) {
    std::iota(up_.begin(), up_.end(), 0);
  }

  /// The root, and whether the sign is the other one.
  std::pair<std::uint32_t, bool> find(std::uint32_t node) {
    bool is_turned = false;
    for (; up_[node] != node; node = up_[node]) {
      const std::uint32_t next = up_[node];
      is_turned_[node] ^= up_[next] != next ? is_turned_[next] : 0;
      is_turned = is_turned != (is_turned_[node] != 0);
      up_[node] = up_[next];
    }
    return {node, is_turned};
  }
  void join(std::uint32_t a, std::uint32_t b, bool is_opposite) {
    const auto [root_a, a_turned] = find(a);
    const auto [root_b, b_turned] = find(b);
    if (root_a == root_b) return;
    up_[root_a] = root_b;
    is_turned_[root_a] = (a_turned != b_turned) != is_opposite ? 1 : 0;
  }

 private:
  std::vector<std::uint32_t> up_;
  std::vector<std::uint8_t> is_turned_;  ///< against the next one up
};

}  // namespace

std::vector<LinkLabel> priority_labels(std::uint32_t poles, std::span<const PoleLink> links,
                                       std::span<const std::uint32_t> outside) {
  return Spreading(poles, links).run(outside);
}

std::vector<LinkLabel> forest_labels(std::uint32_t poles, std::span<const PoleLink> links,
                                     std::span<const std::uint32_t> outside) {
  Signs signs(poles + 1);
  for (const std::uint32_t pole : outside) signs.join(pole, poles, false);
  std::vector<PoleLink> sorted(links.begin(), links.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const PoleLink& a, const PoleLink& b) { return a.weight > b.weight; });
  for (const PoleLink& link : sorted) signs.join(link.a, link.b, link.is_opposite);
  const auto [root, is_turned] = signs.find(poles);
  std::vector<LinkLabel> labels(poles, LinkLabel::kNone);
  for (std::uint32_t p = 0; p < poles; ++p) {
    const auto [own_root, own_turned] = signs.find(p);
    if (own_root == root)
      labels[p] = own_turned == is_turned ? LinkLabel::kOutside : LinkLabel::kInside;
  }
  return labels;
}

}  // namespace stream_recon
