// Dot products, transforms, and copies of vertices.
#include "measure/bench/fair/sums.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "measure/bench/fair/groups.hpp"
#include "measure/bench/fair/highway.hpp"
#include "measure/bench/fair/type.hpp"

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

constexpr std::pair<std::size_t, std::size_t> no_cache_holds{10'000'000, 0};

Sizes vertex_sizes() {
  Sizes sizes = batch_sizes();
  sizes.push_back(no_cache_holds);
  return sizes;
}

/// Each product is rounded.
void add_transforms(std::vector<Group>& to) {
  Operation<Transform> columns("transform, columns", vertex_sizes());
  columns.in_loop<TypeTransform>(Role::ours).in_batch<BatchTransform>(Role::ours);
  columns.in_loop<Columns<EachRounded>>();

  Operation<TransformInterleaved> interleaved("transform, interleaved", vertex_sizes());
  interleaved.in_loop<TypeTransformInterleaved>(Role::ours);
  interleaved.in_batch<BatchTransformInterleaved>(Role::ours);
  interleaved.in_loop<Interleaved<EachRounded>>();
#if defined(FAIR_HIGHWAY)
  columns.in_batch<HighwayTransform>();
  interleaved.in_batch<HighwayTransformInterleaved>();
#endif
  columns.add_to(to);
  interleaved.add_to(to);
}

/// Each sum is rounded once.
void add_fused_transforms(std::vector<Group>& to) {
  Operation<Transform> columns("fused transform, columns", vertex_sizes());
  columns.in_batch<BatchFused>(Role::ours);
  columns.in_batch<Columns<SumRounded>>().in_batch<Columns<SumInDouble>>();

  Operation<TransformInterleaved> interleaved("fused transform, interleaved", vertex_sizes());
  interleaved.in_batch<BatchFusedInterleaved>(Role::ours);
  interleaved.in_batch<Interleaved<SumRounded>>().in_batch<Interleaved<SumInDouble>>();
#if defined(FAIR_HIGHWAY)
  columns.in_batch<HighwayFused>();
  interleaved.in_batch<HighwayFusedInterleaved>();
#endif
#if defined(FAIR_EIGEN)
  columns.in_batch<EigenColumns>();
  interleaved.in_batch<EigenVertices<float>>();
#endif
  columns.add_to(to);
  interleaved.add_to(to);
}

void add_copies(std::vector<Group>& to) {
  Operation<Copy> copies("copy of vertices", {{1'000'000, 0}, no_cache_holds});
  copies.in_batch<MemcpyColumns>();
#if defined(__SSE2__)
  copies.in_batch<StreamColumns>();
#endif
  copies.add_to(to);
}

}  // namespace

void add_sums(std::vector<Group>& to) {
  add_dot(to);
  add_transforms(to);
  add_fused_transforms(to);
  add_copies(to);
}

}  // namespace fair
