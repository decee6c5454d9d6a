// fixproof measure --host.
//
// The file that --json names:
//
//   made       {command, seed, compiler, date} as of --accuracy, and {flags, processor}
//   libraries  {libfixmath, FreeType}: whether each was built in
//   rounds     how often every loop was timed; operands: how many its arrays have
//   host       a list of {operation: mul, div, sqrt or cos; contender; alike: presets that run the
//              same code; kind: type, plain, library or floating; rounding: as its maker states it;
//              throughput_ns: {min, median, spread}; chain_ns: the same, or null where there is no
//              chain; cases, exceptions: results judged, and those of them that break the rule
//              within what is known of the contender; accuracy: {max, mean, rms, correct}}
//   vertices   a list of {contender, alike, kind, rounding; ns: {min, median, spread} of a vertex;
//              per_second: {most, median}; cases, exceptions, accuracy: of its coordinates}
//
// Times are nanoseconds of one operation; spread is the third quartile less the first, by the
// median. Errors are in units of the last place of 16.16; correct is the share, 0 ... 1, within
// half of one.
#include "verify/measure/measure.hpp"

namespace fixproof {}  // namespace fixproof
