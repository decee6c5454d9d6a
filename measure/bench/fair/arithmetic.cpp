// Products, quotients, roots and conversions.
#include "measure/bench/fair/groups.hpp"
#include "measure/bench/fair/highway.hpp"
#include "measure/bench/fair/plain.hpp"
#include "measure/bench/fair/type.hpp"

namespace fair {

namespace {

void add_products(std::vector<Group>& to) {
  Operation<Multiply> all("multiply", batch_sizes());
  all.each<TypeMultiply<q16_16>>(Role::ours).in_batch<BatchMultiply<q16_16>>(Role::ours);
  all.each<IdiomMultiply>().each<IdiomMultiplyTruncating>().each<DoubleMultiply>();
#if defined(FAIR_LIBFIXMATH)
  all.each<FixmathMultiply>();
#endif
#if defined(FAIR_FREETYPE)
  all.each<FreetypeMultiply>();
#endif
#if defined(FAIR_HIGHWAY)
  all.in_batch<HighwayMultiply>();
#endif
  all.add_to(to);
}

void add_saturating_products(std::vector<Group>& to) {
  Operation<MultiplySaturating> all("saturating multiply", batch_sizes());
  all.each<TypeMultiply<q16_16_saturating>>(Role::ours);
  all.in_batch<BatchMultiply<q16_16_saturating>>(Role::ours);
  all.each<IdiomMultiplySaturating>().each<DoubleMultiplySaturating>();
#if defined(FAIR_LIBFIXMATH)
  all.each<FixmathMultiplySaturating>();
#endif
#if defined(FAIR_HIGHWAY)
  all.in_batch<HighwayMultiplySaturating>();
#endif
  all.add_to(to);
}

void add_quotients(std::vector<Group>& to) {
  Operation<Divide> all("divide", batch_sizes());
  all.each<TypeDivide>(Role::ours).in_batch<BatchDivide>(Role::ours);
  all.in_loop<Each<VectorizableDivide>>(Role::ours);
  all.each<IdiomDivide>().each<IdiomDivideTruncating>().each<DoubleDivide>();
#if defined(FAIR_LIBFIXMATH)
  all.each<FixmathDivide>();
#endif
#if defined(FAIR_FREETYPE)
  all.each<FreetypeDivide>();
#endif
#if defined(FAIR_HIGHWAY)
  all.in_batch<HighwayDivide>();
#endif
  all.add_to(to);
}

void add_roots(std::vector<Group>& to) {
  Operation<Root> all("sqrt", batch_sizes());
  all.each<TypeRoot>(Role::ours).in_batch<BatchRoot>(Role::ours);
  all.each<DoubleRoot>();
#if defined(FAIR_LIBFIXMATH)
  all.each<FixmathRoot>();
#endif
#if defined(FAIR_HIGHWAY)
  all.in_batch<HighwayRoot>();
#endif
  all.add_to(to);
}

void add_conversions(std::vector<Group>& to) {
  Operation<ToDouble> both("to double and back", {});
  both.in_chain<TypeThereAndBack>(Role::ours);
  both.in_chain<IdiomThereAndBack>().in_chain<FloorThereAndBack>();

  Operation<FromDouble> from("from double", batch_sizes());
  from.in_loop<Each<TypeFromDouble>>(Role::ours).in_batch<BatchFromDouble>(Role::ours);
  from.in_loop<Each<VectorizableFromDouble>>(Role::ours);
  from.in_loop<Each<RintFromDouble>>().in_loop<Each<FloorFromDouble>>();

  Operation<ToDouble> back("to double", batch_sizes());
  back.in_loop<Each<TypeToDouble>>(Role::ours).in_batch<BatchToDouble>(Role::ours);
  back.in_loop<Each<IdiomToDouble>>();
#if defined(FAIR_LIBFIXMATH)
  both.in_chain<FixmathThereAndBack>();
  from.in_loop<Each<FixmathFromDouble>>();
  back.in_loop<Each<FixmathToDouble>>();
#endif
#if defined(FAIR_HIGHWAY)
  from.in_batch<HighwayFromDouble>();
  back.in_batch<HighwayToDouble>();
#endif
  both.add_to(to);
  from.add_to(to);
  back.add_to(to);
}

}  // namespace

void add_arithmetic(std::vector<Group>& to) {
  add_products(to);
  add_saturating_products(to);
  add_quotients(to);
  add_roots(to);
  add_conversions(to);
}

}  // namespace fair
