/// \file
/// recorded<Number>: a number that writes down what is computed with it, to find the first
/// operation in which two runs differ. docs/recorder.md is the guide.
///
///     #include "record/recorded.hpp"
///
///     using real = fixproof::recorded<fixproof::q16_16>;    // the one change to a program
///     const fixproof::record::log log("this-machine.log");  // until the end of its scope
///     for (int i = 0; i < frames; ++i) {
///       fixproof::record::frame(i);
///       step();                                             // sums and products of `real`
///     }
///
/// Then `fixproof desync this-machine.log other-machine.log`.
///
/// Recording is off unless FIXPROOF_RECORD is defined as 1: then recorded<Number> is Number itself,
/// and the functions of fixproof::record do nothing. All sources of a program must agree on it.
///
/// A folder of its own rather than a header of fixed/: it writes files and has a state for each
/// thread, and fixed/ has neither. Like fixed/ it needs C++20 and the standard library alone. It
/// includes every function of fixed/, but not batch/ and not fixed/eigen.hpp.
#pragma once

#include "fixed/angle.hpp"
#include "fixed/bytes.hpp"
#include "fixed/exponential.hpp"
#include "fixed/fixed.hpp"
#include "fixed/power.hpp"
#include "fixed/trigonometry.hpp"

#if !defined(FIXPROOF_RECORD)
#define FIXPROOF_RECORD 0
#endif

#if FIXPROOF_RECORD
#include "record/checked.hpp"
#include "record/functions.hpp"
#include "record/log.hpp"
#include "record/number.hpp"
#include "record/text.hpp"
#else
#include "record/silent.hpp"
#endif

namespace fixproof {

#if FIXPROOF_RECORD
/// The number type, recorded if FIXPROOF_RECORD is 1, and itself otherwise.
template <class Number>
using recorded = recorded_number<Number>;
#else
template <class Number>
using recorded = Number;
#endif

}  // namespace fixproof
