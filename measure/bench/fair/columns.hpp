/// @file
/// The operands of an operation, as 16.16 words, and the arrays that contenders read and write.
#pragma once

#include <sys/mman.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <random>
#include <type_traits>
#include <vector>

namespace fair {

/// An exact result or an error, in units in the last place of 16.16. Its 64 bits or more hold every
/// product and every sum of products that is in range.
using Ulp = long double;
inline constexpr Ulp no_result = std::numeric_limits<Ulp>::infinity();

/// Up to three words for each element.
struct Words {
  std::vector<std::int32_t> a, b, c;

  [[nodiscard]] std::size_t size() const { return a.size(); }
  void add(std::int32_t x, std::int32_t y, std::int32_t z) {
    a.push_back(x);
    b.push_back(y);
    c.push_back(z);
  }
};

/// The matrix of the transforms: turned and scaled, and a translation.
inline constexpr std::array<std::array<std::int32_t, 4>, 3> matrix_words{
    {{52345, -23456, 32123, 65536},
     {-40961, 50001, 12347, -98304},
     {20011, 34567, -61111, 131071}}};

template <class T>
T of_word(std::int32_t word) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(word) / 65536;
  } else if constexpr (std::is_integral_v<T>) {
    return word;
  } else {
    return T::from_raw(word);
  }
}

template <class T>
Ulp ulps(T x) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<Ulp>(x) * 65536;
  } else if constexpr (std::is_integral_v<T>) {
    return static_cast<Ulp>(x);
  } else {
    return static_cast<Ulp>(x.raw());
  }
}

template <class T>
struct element_of {
  using number = T;
  static constexpr std::size_t width = 1;
};
template <class T>
struct element_of<std::array<T, 3>> {
  using number = T;
  static constexpr std::size_t width = 3;
};

/// An array of numbers that begins `offset` bytes after a multiple of 64, rounded up to the
/// alignment of its type. The fixed multiple of 64 that `place` adds keeps arrays of one cell from
/// being a multiple of a page apart. Long arrays lie in huge pages where the system has them:
/// which small pages a contender happens to get decides which lines its arrays push out of the
/// caches, and moved ratios by a tenth.
template <class T>
class Column {
 public:
  Column() = default;
  Column(std::size_t count, std::size_t offset, std::size_t place)
      : bytes_(in_pages(count * sizeof(T) + page)),
        at_(static_cast<T*>(static_cast<void*>(bytes_.get() + place * 5 * 64 + aligned(offset)))) {
    std::uninitialized_value_construct_n(at_, count);
  }
  [[nodiscard]] T* data() const { return at_; }

 private:
  static constexpr std::size_t page = 4096;
  static constexpr std::size_t huge_page = std::size_t{2} << 20;
  static constexpr std::size_t aligned(std::size_t offset) {
    return (offset + alignof(T) - 1) / alignof(T) * alignof(T);
  }
  struct Free {
    void operator()(std::byte* at) const { std::free(at); }  // NOLINT(*-no-malloc)
  };
  static std::byte* in_pages(std::size_t size) {
    const std::size_t unit = size < huge_page ? page : huge_page;
    const std::size_t whole = (size + unit - 1) / unit * unit;
    void* const at = std::aligned_alloc(unit, whole);
    if (at == nullptr) throw std::bad_alloc();
    if (unit == huge_page) madvise(at, whole, MADV_HUGEPAGE);  // a refusal costs only speed
    return static_cast<std::byte*>(at);
  }
  std::unique_ptr<std::byte, Free> bytes_;
  T* at_ = nullptr;
};

/// What a kernel reads and writes. Unused pointers are null.
template <class In, class Out>
struct View {
  using number = typename element_of<In>::number;
  const In *a, *b, *c;
  Out *x, *y, *z;
  std::array<std::array<number, 4>, 3> rows;
};

/// The arrays of one contender: Op::inputs columns, filled from the words, and Op::outputs columns.
template <class Op, class In, class Out>
class Arrays {
 public:
  Arrays(const Words& words, std::size_t count, std::size_t offset) : count_(count) {
    for (std::size_t k = 0; k < Op::inputs; ++k) {
      in_[k] = Column<In>(count, offset, k);
      for (std::size_t i = 0; i < count; ++i)
        in_[k].data()[i] = Op::template input<In>(words, k, i);
    }
    for (std::size_t k = 0; k < Op::outputs; ++k) out_[k] = Column<Out>(count, offset, 3 + k);
    using number = typename View<In, Out>::number;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 4; ++j) rows_[k][j] = of_word<number>(matrix_words[k][j]);
    }
  }

  [[nodiscard]] View<In, Out> view() const {
    return {in_[0].data(),  in_[1].data(),  in_[2].data(), out_[0].data(),
            out_[1].data(), out_[2].data(), rows_};
  }

  /// Returns result k of element i.
  [[nodiscard]] Ulp result(std::size_t i, std::size_t k) const {
    if constexpr (element_of<Out>::width == 1) {
      return ulps(out_[k].data()[i]);
    } else {
      return ulps(out_[0].data()[i][k]);
    }
  }

 private:
  std::size_t count_;
  std::array<Column<In>, 3> in_;
  std::array<Column<Out>, 3> out_;
  std::array<std::array<typename View<In, Out>::number, 4>, 3> rows_{};
};

/// Words of `bits` bits with a sign. Half of them end in zeros, so that results can be ties.
class Draw {
 public:
  std::int32_t word(int bits) {
    const auto x = static_cast<std::int32_t>(random_()) >> (32 - bits);
    return random_() % 2 == 0 ? x : x & -(1 << random_() % 16);
  }

 private:
  std::mt19937 random_{54};
};

}  // namespace fair
