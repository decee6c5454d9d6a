/// Tests depth sorting against a linked list.
#include "xsharp/depth.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/types.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using Order = std::vector<std::size_t>;

/// The object list of chapter 53: doubly linked between two sentinels, at -32768.0 and at the
/// largest depth. From the second object on, the sort moves each object that is farther than its
/// predecessor behind the nearest earlier object that is not nearer.
class ObjectList {
 public:
  explicit ObjectList(std::size_t objects) : links_(objects + 2) {
    for (std::size_t node = 0; node < links_.size(); ++node) {
      links_[node] = {node - 1, node + 1, 0};
    }
    links_.front().z = -32768 * 65536;
    links_.back().z = 0x7FFFFFFF;
  }

  void sort(const std::vector<std::int32_t>& depths) {
    for (std::size_t i = 0; i < depths.size(); ++i) links_[i + 1].z = depths[i];
    std::size_t node = links_[links_[0].next].next;
    while (node != links_.size() - 1) {
      const std::size_t following = links_[node].next;
      std::size_t behind = links_[node].previous;
      if (links_[behind].z > links_[node].z) {
        take_out(node);
        while (links_[behind].z > links_[node].z) behind = links_[behind].previous;
        put_in(node, behind);
      }
      node = following;
    }
  }

  /// Object indices, starting at 0, from head to tail.
  [[nodiscard]] Order order() const {
    Order result;
    for (std::size_t node = links_[0].next; node != links_.size() - 1; node = links_[node].next) {
      result.push_back(node - 1);
    }
    return result;
  }

 private:
  struct Link {
    std::size_t previous = 0;
    std::size_t next = 0;
    std::int32_t z = 0;
  };

  void take_out(std::size_t node) {
    links_[links_[node].previous].next = links_[node].next;
    links_[links_[node].next].previous = links_[node].previous;
  }

  void put_in(std::size_t node, std::size_t behind) {
    const std::size_t next = links_[behind].next;
    links_[node].previous = behind;
    links_[node].next = next;
    links_[behind].next = node;
    links_[next].previous = node;
  }

  std::vector<Link> links_;
};

Order from_zero(std::size_t count) {
  Order order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

template <class N>
std::vector<N> depths_of(const std::vector<std::int32_t>& raws) {
  std::vector<N> depths;
  for (const std::int32_t raw : raws) depths.push_back(Arithmetic<N>::from_raw(raw));
  return depths;
}

template <class N>
void sort_raws(Order& order, const std::vector<std::int32_t>& raws) {
  const std::vector<N> depths = depths_of<N>(raws);
  sort_by_depth(order, std::span<const N>(depths));
}

template <class N>
struct Depth : testing::Test {};
TYPED_TEST_SUITE(Depth, pipeline::comparing_types, );

TYPED_TEST(Depth, TheFarthestComesFirst) {
  Order order = from_zero(5);
  sort_raws<TypeParam>(order, {-100, -300, -200, INT32_MAX, INT32_MIN});
  EXPECT_EQ(order, (Order{4, 1, 2, 0, 3}));
}

TYPED_TEST(Depth, EqualDepthsKeepTheirPlaces) {
  Order order{3, 1, 0, 2};
  sort_raws<TypeParam>(order, {-7, -7, -9, -7});
  EXPECT_EQ(order, (Order{2, 3, 1, 0}));
}

TYPED_TEST(Depth, NothingToSort) {
  Order none;
  sort_raws<TypeParam>(none, {});
  EXPECT_TRUE(none.empty());
  Order one{0};
  sort_raws<TypeParam>(one, {5});
  EXPECT_EQ(one, Order{0});
}

/// Sorts successive frames of `objects` depths. Each order must be a permutation and match the
/// list.
template <class N>
bool is_the_list(const Integers& depths, std::size_t objects) {
  ObjectList list(objects);
  Order order = from_zero(objects);
  for (std::size_t start = 0; start + objects <= depths.size(); start += objects) {
    std::vector<std::int32_t> frame;
    for (std::size_t i = 0; i < objects; ++i) {
      frame.push_back(static_cast<std::int32_t>(depths[start + i]));
    }
    sort_raws<N>(order, frame);
    list.sort(frame);
    if (order != list.order()) return false;
    if (!std::is_permutation(order.begin(), order.end(), from_zero(objects).begin())) return false;
    for (std::size_t i = 1; i < objects; ++i) {
      if (frame[order[i - 1]] > frame[order[i]]) return false;
    }
  }
  return true;
}

TYPED_TEST(Depth, IsTheListOfObjectsFrameAfterFrame) {
  for (const std::size_t objects : {1U, 2U, 3U, 7U, 12U}) {
    // This small range gives many equal depths.
    EXPECT_TRUE(draws::hold(84, -4, 4, [=](const Integers& depths) {
      return is_the_list<TypeParam>(depths, objects);
    }));
    EXPECT_TRUE(draws::hold_for_raws(
        84, [=](const Integers& depths) { return is_the_list<TypeParam>(depths, objects); }));
  }
}

struct Counted {
  int depth = 0;
  static inline std::size_t comparisons = 0;

  friend bool operator<(const Counted& a, const Counted& b) {
    ++comparisons;
    return a.depth < b.depth;
  }
};

/// The number of comparisons when sorting the depths, starting from `order`.
std::size_t comparisons_for(Order& order, const std::vector<Counted>& depths) {
  Counted::comparisons = 0;
  sort_by_depth(order, std::span<const Counted>(depths));
  return Counted::comparisons;
}

TEST(DepthSort, IsAsLongAsWhatHasChanged) {
  constexpr std::size_t objects = 10'000;
  std::vector<Counted> depths(objects);
  for (std::size_t i = 0; i < objects; ++i) depths[i].depth = static_cast<int>(i / 2);
  Order order = from_zero(objects);
  EXPECT_LT(comparisons_for(order, depths), objects);
  // Every hundredth object moves behind the ten before it.
  for (std::size_t i = 100; i < objects; i += 100) depths[i].depth -= 10;
  EXPECT_LT(comparisons_for(order, depths), 2 * objects);
  // The order reverses completely: 50 million pairs.
  for (std::size_t i = 0; i < objects; ++i) depths[i].depth = -static_cast<int>(i / 2);
  EXPECT_LT(comparisons_for(order, depths), 10 * objects * 14);
  Order expected = from_zero(objects);
  std::stable_sort(expected.begin(), expected.end(),
                   [&](std::size_t a, std::size_t b) { return depths[a].depth < depths[b].depth; });
  // Earlier sorts may have swapped equal pairs, so compare the depths and not the objects.
  for (std::size_t i = 0; i < objects; ++i) {
    ASSERT_EQ(depths[order[i]].depth, depths[expected[i]].depth);
  }
}

TEST(DepthSort, KeepsEqualDepthsWhenItMerges) {
  constexpr std::size_t objects = 3'000;
  std::vector<std::int32_t> depths(objects);
  for (std::size_t i = 0; i < objects; ++i) depths[i] = -static_cast<std::int32_t>(i / 3);
  Order order = from_zero(objects);
  sort_raws<double>(order, depths);
  for (std::size_t i = 0; i < objects; ++i) {
    ASSERT_EQ(order[i], objects - 3 - i / 3 * 3 + i % 3);
  }
}

}  // namespace
}  // namespace xsharp
