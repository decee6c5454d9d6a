#include "tests/fixed/formats/integer.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
#include <memory>
#include <new>
#include <ostream>
#include <type_traits>

namespace reference {

namespace {

using Number = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;
static_assert(std::is_trivially_destructible_v<Number>);

}  // namespace

struct integer::Access {
  static_assert(sizeof(Number) <= sizeof(integer) && alignof(Number) <= alignof(integer));

  // NOLINTBEGIN(*-reinterpret-cast): the bytes hold a Number from the constructor on
  static Number* place(integer& x) { return reinterpret_cast<Number*>(x.storage_.data()); }
  static Number& of(integer& x) { return *std::launder(place(x)); }
  static const Number& of(const integer& x) {
    return *std::launder(reinterpret_cast<const Number*>(x.storage_.data()));
  }
  // NOLINTEND(*-reinterpret-cast)
  static integer from(const Number& number) {
    integer x{Nothing()};
    std::construct_at(place(x), number);
    return x;
  }
};

// NOLINTBEGIN(*-member-init): construct_at does
integer::integer(bool negative, std::uint64_t magnitude) {
  Number* number = std::construct_at(Access::place(*this), magnitude);
  if (negative) number->backend().negate();
}
integer::integer(const integer& other) {
  std::construct_at(Access::place(*this), Access::of(other));
}
// NOLINTEND(*-member-init)
integer& integer::operator=(const integer& other) {
  if (this != &other) Access::of(*this) = Access::of(other);
  return *this;
}

std::uint64_t integer::low_bits() const {
  const Number& number = Access::of(*this);
  const Number low = abs(number) % (Number(1) << 64);
  const auto magnitude = static_cast<std::uint64_t>(low);
  return number < 0 ? 0 - magnitude : magnitude;
}

std::string integer::str() const { return Access::of(*this).str(); }

integer integer::operator-() const { return Access::from(-Access::of(*this)); }
integer& integer::operator+=(const integer& b) {
  Access::of(*this) += Access::of(b);
  return *this;
}
integer& integer::operator-=(const integer& b) {
  Access::of(*this) -= Access::of(b);
  return *this;
}
integer& integer::operator*=(const integer& b) {
  Access::of(*this) *= Access::of(b);
  return *this;
}
integer& integer::operator/=(const integer& b) {
  Access::of(*this) /= Access::of(b);
  return *this;
}
integer& integer::operator%=(const integer& b) {
  Access::of(*this) %= Access::of(b);
  return *this;
}
integer& integer::operator<<=(int places) {
  Access::of(*this) <<= places;
  return *this;
}
integer& integer::operator>>=(int places) {
  Access::of(*this) >>= places;
  return *this;
}

int integer::compare(const integer& b) const { return Access::of(*this).compare(Access::of(b)); }

std::ostream& operator<<(std::ostream& out, const integer& x) { return out << x.str(); }

integer power(int base, int exponent) {
  return integer::Access::from(
      boost::multiprecision::pow(Number(base), static_cast<unsigned>(exponent)));
}

integer floor_root(const integer& n) {
  return integer::Access::from(boost::multiprecision::sqrt(integer::Access::of(n)));
}

}  // namespace reference
