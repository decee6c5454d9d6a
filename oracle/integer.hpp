#pragma once

// GCC 12 gives two false warnings wherever the library is inlined: it follows the branch for
// allocated digits into objects that store theirs in place, and assumes any length for a string
// before an insertion (GCC bug 105651).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wrestrict"
#endif
#include <boost/multiprecision/cpp_int.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

namespace oracle {

/// An integer of any size. Expression templates are off, so that `auto` never holds a reference to
/// a temporary.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

/// An integer with a sign and at least 127 bits. An operation throws if its result needs more bits,
/// so no result wraps.
using Wide = boost::multiprecision::checked_int128_t;

}  // namespace oracle
