/// @file
/// recorded<Number>: a number that logs every operation, so that `fixproof desync` finds the first
/// operation in which two runs differ. docs/recorder.md is the guide.
///
///     #include "fixed/record/recorded.hpp"
///
///     using real = fixproof::recorded<fixproof::q16_16>;    // before: fixproof::q16_16
///     const fixproof::record::log log("this-machine.log");  // until the end of its scope
///     for (int i = 0; i < frames; ++i) {
///       fixproof::record::frame(i);
///       step();                                             // sums and products of `real`
///     }
///
/// Then `fixproof desync this-machine.log other-machine.log`.
///
/// Recording is on if FIXPROOF_RECORD is defined as 1. Otherwise recorded<Number> is Number itself,
/// and the functions of fixproof::record do nothing. All sources of a program must agree on the
/// macro.
///
/// This is a folder of its own and not a header of fixed/, because it writes files and has state
/// for each thread. Like fixed/, it needs only C++20 and the standard library. It covers every
/// function of fixed/ except those of fixed/eigen.hpp, and none of fixed/batch/.
#pragma once

#include "fixed/bytes.hpp"
#include "fixed/fixed.hpp"

#if !defined(FIXPROOF_RECORD)
/// Whether recorded numbers record.
#define FIXPROOF_RECORD 0
#endif

#if FIXPROOF_RECORD
#include "fixed/record/checked.hpp"
#include "fixed/record/functions.hpp"
#include "fixed/record/log.hpp"
#include "fixed/record/number.hpp"
#include "fixed/record/results.hpp"
#include "fixed/record/text.hpp"
#else
#include "fixed/record/silent.hpp"
#endif

namespace fixproof {

#if FIXPROOF_RECORD
/// The recorded number type if FIXPROOF_RECORD is 1, and Number itself otherwise.
template <class Number>
using recorded = recorded_number<Number>;
#else
/// Number itself, because FIXPROOF_RECORD is not 1.
template <class Number>
using recorded = Number;
#endif

}  // namespace fixproof
