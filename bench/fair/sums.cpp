// Dot products, transforms, and copies of vertices.
#include "bench/fair/sums.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "bench/fair/groups.hpp"
#include "bench/fair/highway.hpp"
#include "bench/fair/type.hpp"

namespace fair {

namespace {

void add_dot(std::vector<Group>& to) {
  Operation<Dot> all("dot", batch_sizes());
  all.in_loop<TypeDot>(Role::ours).in_batch<BatchDot>(Role::ours);
  all.in_loop<IdiomDot>();
#if defined(FAIR_HIGHWAY)
  all.in_batch<HighwayDot>();
#endif
#if defined(FAIR_EIGEN)
  all.in_batch<EigenDot>();
#endif
  all.add_to(to);
}

void add_transforms(std::vector<Group>& to) {
  constexpr std::pair<std::size_t, std::size_t> no_cache_holds{10'000'000, 0};
  Sizes sizes = batch_sizes();
  sizes.push_back(no_cache_holds);

  Operation<Transform> columns("transform, columns", sizes);
  columns.in_loop<TypeTransform>(Role::ours).in_batch<BatchTransform>(Role::ours);
  columns.in_loop<Columns<EachRounded>>().in_loop<Columns<SumRounded>>();
  columns.in_loop<Columns<SumInDouble>>();

  Operation<TransformInterleaved> interleaved("transform, interleaved", sizes);
  interleaved.in_loop<TypeTransformInterleaved>(Role::ours);
  interleaved.in_batch<BatchTransformInterleaved>(Role::ours);
  interleaved.in_loop<Interleaved<EachRounded>>().in_loop<Interleaved<SumRounded>>();
  interleaved.in_loop<Interleaved<SumInDouble>>();

  Operation<Copy> copies("copy of vertices", {{1'000'000, 0}, no_cache_holds});
  copies.in_batch<MemcpyColumns>();
#if defined(FAIR_HIGHWAY)
  columns.in_batch<HighwayTransform>();
  interleaved.in_batch<HighwayTransformInterleaved>();
#endif
#if defined(FAIR_EIGEN)
  columns.in_batch<EigenColumns>();
  interleaved.in_batch<EigenVertices<float>>();
#endif
#if defined(__SSE2__)
  copies.in_batch<StreamColumns>();
#endif
  columns.add_to(to);
  interleaved.add_to(to);
  copies.add_to(to);
}

}  // namespace

void add_sums(std::vector<Group>& to) {
  add_dot(to);
  add_transforms(to);
}

}  // namespace fair
