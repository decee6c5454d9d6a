/// \file
/// The operations that work element by element, for batch/detail/blocks.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Products and sums.
template <class N>
struct sum_results {
  i32 values;
  i32 bad;

  template <class Part>
  FIXED_LANE_FUNCTION void store(void* out, std::size_t i, Part part) const {
    FIXED_LANES::store<N>(out, i, values, part);
  }
  FIXED_LANE_FUNCTION void note(std::size_t i, std::uint32_t of, fault_recorder& found) const {
    note_overflows<N::rules.product_range()>(bad, i, found, of);
  }
};

template <class N>
struct product_blocks {
  using number = N;
  static constexpr std::size_t size = width;
  static constexpr bool checks_later = N::rules.product_range() != overflow::wrap;
  const void* a;
  const void* b;
  void* out;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION sum_results<N> at(std::size_t i, Part part) const {
    i32 bad{};
    const i32 values = product<N>(load<N>(a, i, part), load<N>(b, i, part), bad);
    return {values, bad};
  }
  [[nodiscard]] FIXED_LANE_FUNCTION i32 at(std::size_t i, u64& sums) const {
    return unchecked_product<N>(load<N>(a, i), load<N>(b, i), sums);
  }
};

template <class N>
struct mul_add_blocks {
  using number = N;
  static constexpr std::size_t size = width;
  static constexpr bool checks_later = N::rules.product_range() != overflow::wrap;
  const void* a;
  const void* b;
  const void* c;
  void* out;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION sum_results<N> at(std::size_t i, Part part) const {
    i32 bad{};
    const i32 values =
        product_and_sum<N>(load<N>(a, i, part), load<N>(b, i, part), load<N>(c, i, part), bad);
    return {values, bad};
  }
  [[nodiscard]] FIXED_LANE_FUNCTION i32 at(std::size_t i, u64& sums) const {
    return unchecked_product_and_sum<N>(load<N>(a, i), load<N>(b, i), load<N>(c, i), sums);
  }
};

/// Half a block of quotients.
template <class N>
struct quotient_results {
  half_i32 values;
  std::uint32_t errors;
  std::uint32_t overflows;

  template <class Part>
  FIXED_LANE_FUNCTION void store(void* out, std::size_t i, Part part) const {
    store_half<N>(out, i, values, part);
  }
  FIXED_LANE_FUNCTION void note(std::size_t i, std::uint32_t of, fault_recorder& found) const {
    if ((errors & of) != 0) [[unlikely]] {
      found.note_bits(fault::divide_error, errors & of, i);
    }
    if ((overflows & of) != 0) [[unlikely]] {
      found.note_bits(fault::overflow, overflows & of, i);
    }
  }
};

template <class N>
struct quotient_blocks {
  static constexpr std::size_t size = width / 2;
  static constexpr bool is_large = true;
  static constexpr bool checks_later = false;
  const void* n;
  const void* d;
  void* out;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION quotient_results<N> at(std::size_t i, Part part) const {
    quotient_results<N> results;  // NOLINT(*-pro-type-member-init): all members are set below
    divisor_lanes divisor = divisor_of<N>(load_half<N>(d, i, part));
    divisor.zeros &= part.bits;  // other lanes are zero, but no error
    results.values =
        quotient<N>(load_half<N>(n, i, part), divisor, results.errors, results.overflows);
    return results;
  }
};

template <class Raw>
struct root_results {
  i32 values;
  std::uint32_t errors;

  template <class Part>
  FIXED_LANE_FUNCTION void store(void* out, std::size_t i, Part part) const {
    FIXED_LANES::store<Raw>(out, i, values, part);
  }
  FIXED_LANE_FUNCTION void note(std::size_t i, std::uint32_t of, fault_recorder& found) const {
    if ((errors & of) != 0) [[unlikely]] {
      found.note_bits(fault::domain_error, errors & of, i);
    }
  }
};

template <class Raw, int F>
struct root_blocks {
  static constexpr std::size_t size = width;
  static constexpr bool checks_later = false;
  const void* x;
  void* out;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION root_results<Raw> at(std::size_t i, Part part) const {
    std::uint32_t errors = 0;
    const i32 values = nearest_roots<F>(load<Raw>(x, i, part), errors);
    return {values, errors};
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
