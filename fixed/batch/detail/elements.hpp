/// @file
/// The operations that work element by element, for fixed/batch/detail/blocks.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Products, and c added if `adds`.
template <class Number, bool adds>
struct product_blocks {
  using number = Number;
  using check = u64;
  static constexpr std::size_t size = width;
  static constexpr overflow range = Number::rules.product_range();
  static constexpr bool in_groups = range != overflow::wrap;
  void* out;
  const void* a;
  const void* b;
  const void* c = nullptr;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION auto exact(std::size_t i, Part part) const {
    const auto product = exact_product<Number>(load<Number>(a, i, part), load<Number>(b, i, part));
    if constexpr (adds) {
      return exact_sum<Number>(product, load<Number>(c, i, part));
    } else {
      return product;
    }
  }
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION i32 at(std::size_t i, Part part, u64& sums) const {
    if constexpr (range == overflow::wrap) {
      i32 bad{};
      return rounded_product<Number>(exact(i, part), bad);
    } else {
      return unchecked<Number>(exact(i, part), sums);
    }
  }
  FIXED_LANE_FUNCTION static bool is_clean(u64 sums) { return in_range<Number>(sums); }
  template <class Part>
  FIXED_LANE_FUNCTION void note(std::size_t i, Part part, fault_recorder& found) const {
    i32 bad{};
    store<Number>(out, i, rounded_product<Number>(exact(i, part), bad), part);
    note_overflows<range>(bad, i, found, part.bits);
  }
};

/// Half a block of quotients.
template <class Number>
struct quotient_blocks {
  using number = Number;
  using check = std::uint32_t;  // the lanes with a fault
  static constexpr std::size_t size = width / 2;
  static constexpr bool in_groups = true;
  void* out;
  const void* n;
  const void* d;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION divisor_lanes divisor(std::size_t i, Part part) const {
    divisor_lanes lanes = divisor_of<Number>(load_half<Number>(d, i, part));
    lanes.zeros &= part.bits;  // other lanes are zero, but no error
    return lanes;
  }
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION std::uint32_t zeros(std::size_t i, Part part) const {
    return divisor(i, part).zeros;
  }
  /// Whether a divisor of four blocks is zero.
  [[nodiscard]] FIXED_LANE_FUNCTION bool have_zero(std::size_t i) const {
    const half_i32 first = lesser(used(i), used(i + size));
    const half_i32 second = lesser(used(i + 2 * size), used(i + 3 * size));
    return zero_bits(lesser(first, second)) != 0;
  }
  [[nodiscard]] FIXED_LANE_FUNCTION half_i32 used(std::size_t i) const {
    return used_part<Number>(load_half<Number>(d, i, whole_block{}));
  }
  /// @pre zeros() is 0
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION half_i32 at(std::size_t i, Part part,
                                                std::uint32_t& faults) const {
    std::uint32_t errors = 0;
    std::uint32_t overflows = 0;
    divisor_lanes by = divisor(i, part);
    // Lanes beyond a part are zero, and divide by 1.
    if constexpr (std::is_same_v<Part, whole_block>) by.value = doubles(by.stored);
    by.zeros = 0;
    const half_i32 values =
        quotient_if_any<Number>(load_half<Number>(n, i, part), by, errors, overflows);
    faults |= errors | overflows;
    return values;
  }
  FIXED_LANE_FUNCTION static bool is_clean(std::uint32_t faults) { return faults == 0; }
  template <class Part>
  FIXED_LANE_FUNCTION void note(std::size_t i, Part part, fault_recorder& found) const {
    std::uint32_t errors = 0;
    std::uint32_t overflows = 0;
    store<Number>(
        out, i,
        quotient<Number>(load_half<Number>(n, i, part), divisor(i, part), errors, overflows), part);
    note_lanes(fault::divide_error, errors, i, found);
    note_lanes(fault::overflow, overflows, i, found);
  }
};

#if FIXED_LANE_BYTES == 64
/// Half a block of square roots, as detail::nearest_root() does it with FMA. For so few, the root
/// of doubles takes less time than a root of floats and its correction.
template <class Raw, int Point>
struct root_halves {
  using number = Raw;
  using check = std::uint32_t;  // the lanes with a fault
  void* out;
  const void* x;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION half_i32 at(std::size_t i, Part part,
                                                std::uint32_t& errors) const {
    const half_i32 from = load_half<Raw>(x, i, part);
    errors = bits(from);
    constexpr double before = 1 << Point % 2;
    constexpr double after = 1 << Point / 2;
    return low_words(whole<true>(root(doubles(from) * before) * after + 0.5));
  }
  FIXED_LANE_FUNCTION static bool is_clean(std::uint32_t errors) { return errors == 0; }
};
#endif

template <class Raw, int Point>
struct root_blocks {
  using number = Raw;
  using check = std::uint32_t;  // the lanes with a fault
  static constexpr std::size_t size = width;
  static constexpr bool in_groups = false;
  void* out;
  const void* x;

#if FIXED_LANE_BYTES == 64
  [[nodiscard]] FIXED_LANE_FUNCTION root_halves<Raw, Point> half() const { return {out, x}; }
#endif
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION i32 at(std::size_t i, Part part, std::uint32_t& errors) const {
    return nearest_roots<Point>(load<Raw>(x, i, part), errors);
  }
  FIXED_LANE_FUNCTION static bool is_clean(std::uint32_t errors) { return errors == 0; }
  template <class Part>
  FIXED_LANE_FUNCTION void note(std::size_t i, Part part, fault_recorder& found) const {
    std::uint32_t errors = 0;
    store<Raw>(out, i, at(i, part, errors), part);
    note_lanes(fault::domain_error, errors, i, found);
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
