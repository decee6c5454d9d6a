#pragma once

// GCC 12 reports two faults that are not there wherever the library is inlined: it follows the
// branch for allocated digits into objects that keep theirs in place, and takes the length of a
// string before an insertion for anything at all (GCC bug 105651).
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

/// An integer of any size. Expression templates are off so that `auto` never holds a reference to
/// a temporary.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

}  // namespace oracle
