// Sines and cosines of radians.
#include "measure/bench/fair/groups.hpp"
#include "measure/bench/fair/highway.hpp"
#include "measure/bench/fair/plain.hpp"
#include "measure/bench/fair/type.hpp"
#include "measure/bench/fair/vector_math.hpp"

namespace fair {

namespace {

template <int bits>
void add_sines(const char* name, std::vector<Group>& to) {
  Operation<Sine<bits>> all(name, batch_sizes());
  all.template each<TypeSine>(Role::ours).template in_batch<BatchSine>(Role::ours);
  all.template each<DoubleSine>().template each<FloatSine>();
#if defined(FAIR_LIBFIXMATH)
  all.template each<FixmathSine>();
#endif
#if defined(FAIR_HIGHWAY)
  all.template in_batch<HighwaySine>();
#endif
#if defined(FAIR_LIBMVEC)
  all.template in_batch<VectorSine<Mvec>>();
#endif
#if defined(FAIR_SLEEF)
  all.template in_batch<VectorSine<Sleef>>();
#endif
  all.add_to(to);
}

void add_both(std::vector<Group>& to) {
  Operation<SineCosine> all("sin_cos within 8", batch_sizes());
  all.in_loop<Each<TypeSineCosine>>(Role::ours).in_batch<BatchSineCosine>(Role::ours);
  all.in_loop<Each<DoubleSineCosine>>();
#if defined(FAIR_LIBFIXMATH)
  all.in_loop<Each<FixmathSineCosine>>();
#endif
#if defined(FAIR_HIGHWAY)
  all.in_batch<HighwaySineCosine>();
#endif
#if defined(FAIR_LIBMVEC)
  all.in_batch<VectorSineCosine<Mvec>>();
#endif
#if defined(FAIR_SLEEF)
  all.in_batch<VectorSineCosine<Sleef>>();
#endif
  all.add_to(to);
}

}  // namespace

void add_angles(std::vector<Group>& to) {
  add_sines<20>("sin within 8", to);
  add_sines<32>("sin", to);
  add_both(to);
}

}  // namespace fair
