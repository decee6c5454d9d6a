/// @file
/// Integers of 1,024 bits and a sign. Only integer.cpp includes Boost.Multiprecision, whose
/// templates would take every test seconds to compile.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace reference {

class integer {
 public:
  integer() : integer(false, 0) {}
  template <std::integral Int>
  integer(Int value)  // NOLINT(google-explicit-constructor): as among the types of the language
      : integer(value < 0, value < 0 ? 0 - static_cast<std::uint64_t>(value)
                                     : static_cast<std::uint64_t>(value)) {}
  integer(const integer& other);
  integer& operator=(const integer& other);
  ~integer() = default;

  /// The integer modulo 2^bits of Int.
  template <std::integral Int>
  explicit operator Int() const {
    return static_cast<Int>(low_bits());
  }
  [[nodiscard]] std::string str() const;

  integer operator-() const;
  integer& operator+=(const integer& b);
  integer& operator-=(const integer& b);
  integer& operator*=(const integer& b);
  /// Truncates.
  integer& operator/=(const integer& b);
  integer& operator%=(const integer& b);
  integer& operator<<=(int places);
  integer& operator>>=(int places);
  friend integer operator+(integer a, const integer& b) { return a += b; }
  friend integer operator-(integer a, const integer& b) { return a -= b; }
  friend integer operator*(integer a, const integer& b) { return a *= b; }
  friend integer operator/(integer a, const integer& b) { return a /= b; }
  friend integer operator%(integer a, const integer& b) { return a %= b; }
  friend integer operator<<(integer a, int places) { return a <<= places; }
  friend integer operator>>(integer a, int places) { return a >>= places; }

  friend bool operator==(const integer& a, const integer& b) { return a.compare(b) == 0; }
  friend std::strong_ordering operator<=>(const integer& a, const integer& b) {
    return a.compare(b) <=> 0;
  }
  friend std::ostream& operator<<(std::ostream& out, const integer& x);

  friend integer power(int base, int exponent);
  /// The square root, rounded down. @pre n >= 0
  friend integer floor_root(const integer& n);

 private:
  struct Access;
  struct Nothing {};
  explicit integer(Nothing /*yet*/) {}  // NOLINT(*-member-init)
  integer(bool negative, std::uint64_t magnitude);
  [[nodiscard]] std::uint64_t low_bits() const;
  [[nodiscard]] int compare(const integer& b) const;

  /// An integer of Boost.Multiprecision.
  alignas(16) std::array<std::byte, 144> storage_;
};

integer power(int base, int exponent);
integer floor_root(const integer& n);

}  // namespace reference
