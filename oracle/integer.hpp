#pragma once

// GCC 12 follows the branch for allocated digits into objects whose digits are stored in place, and
// reports them as uninitialized wherever the library is inlined.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
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
