// Famous cases: links to cases of docs/findings.md, each with three sentences.
import { html } from "../vendor/lit-html.js";
import { hashOf } from "./state.mjs";

const move = (x, y, z) => `1 0 0 ${x}  0 1 0 ${y}  0 0 1 ${z}`;

const cases = [
  {
    name: "0.5 + 0.5 = 0", finding: 18,
    state: {
      view: "trace", routine: "concat", build: "i8088-on", beside: "i8088-on-repaired",
      operands: `${move("0.5", 0, 0)}  ${move("0.5", 0, 0)}`, step: "differs",
    },
    says: `The 8088 ConcatXforms adds a translation as a low and a high word. Both additions are ADD, so the carry from
      the low words is lost, and 0.5 + 0.5 gives 0. The repaired routine uses ADC for the second one: step on and watch
      the high word.`,
  },
  {
    name: "Cubes one unit too far away", finding: 18,
    state: {
      view: "scenes", scene: "lost_carry", arithmetic: "i8088-on", against: "i8088-on-repaired", play: "no",
      frame: "0",
    },
    says: `The viewer stands at a position with a fraction, so the lost carry shifts whole cubes. On the right is every
      pixel that the repaired routine draws differently. Play the scene, and switch to the repaired arithmetic while it
      runs.`,
  },
  {
    name: "Thirty minutes of drift", finding: 2,
    state: {
      view: "scenes", scene: "twelve_cubes", arithmetic: "i386-off", against: "double", show: "other", play: "no",
      frame: "108000",
    },
    says: `Every step multiplies the last orientation by a small rotation and drops the bits that do not fit. So all
      errors point the same way, and after half an hour the cubes are no longer cubes. On the right are the same cubes
      in double.`,
  },
  {
    name: "The fault that disappears", finding: 3,
    state: { view: "operation", op: "div", in: "q16_16", a: "0x00008001", b: "0x00000001" },
    says: `The rounded 386 divide uses the unsigned DIV, which faults only if the quotient needs more than 32 bits.
      This quotient, 32769, needs the sign bit, so two positive numbers silently give −32767. Without rounding, the
      routine uses IDIV, which raises the divide error.`,
  },
  {
    name: "Halves that split two builds", finding: 2,
    state: { view: "operation", op: "mul", in: "q16_16", a: "0xffffffff", b: "0.5" },
    says: `Minus one unit times 0.5 lies exactly between two words. The 386 adds half a unit to the signed product and
      goes up to 0; the 8088 adds it to the magnitude and goes away from zero. One program, built for both processors,
      draws different vertices.`,
  },
  {
    name: "A switch the wrong way round", finding: 1,
    state: { view: "trace", routine: "div", build: "i386-off", beside: "i8088-on", operands: "2 3", step: "1000" },
    says: `The 8088 divide rounds if its switch is zero; the 386 divide rounds if it is not. With the switches as
      printed, the 386 truncates quotients and the 8088 rounds them. So 2 / 3 ends in aaaa on one and in aaab on the
      other.`,
  },
  {
    name: "A divisor loses its fraction", finding: 4,
    state: { view: "operation", op: "div", in: "q16_16", a: "0x0000ffff", b: "0x0001ffff" },
    says: `The 8088 divides by only the whole part of the divisor. A divisor just below 2 counts as 1, so this quotient
      is twice as large as it should be. A point near the viewer is drawn far from its place, and snaps back at every
      whole distance.`,
  },
  {
    name: "Too small to divide by", finding: 4,
    state: { view: "operation", op: "div", in: "q16_16", a: "1", b: "0x0000ffff" },
    says: `The whole part of any divisor between −1 and 1 is 0. To the 8088, such a division is a division by zero. The
      386 gives the quotient, one unit above 1.`,
  },
  {
    name: "A carry that means nothing", finding: 10,
    state: {
      view: "trace", routine: "div", build: "i8088-off-scanned", beside: "i8088-off", operands: "2.5 2", step: "1000",
    },
    says: `In a scan of the book, one ADC stands after the end of the conditional assembly. There it adds a carry right
      after DIV, which leaves all flags undefined. The model marks every such flag with a question mark, and stops
      where one is read.`,
  },
  {
    name: "Arguments that change", finding: 11,
    state: { view: "trace", routine: "div", build: "i8088-on", beside: "none", operands: "-0.25 -2.75", step: "8" },
    says: `The 8088 divide makes its operands positive in place, in the caller's arguments on the stack. A caller that
      uses them again finds different numbers. Step forward and watch the stack lose both signs.`,
  },
  {
    name: "The translation in every column", finding: 6,
    state: {
      view: "trace", routine: "concat", build: "i386-52", beside: "i386-on",
      operands: `${move(1, 2, 3)}  ${move(4, 5, 6)}`, step: "1000",
    },
    says: `The ConcatXforms of chapter 52 adds the first translation to all four sums of a row. Chapters 53 and 54 add
      it only to the fourth sum, which is right. Here two translations become a transform that is no translation at
      all.`,
  },
  {
    name: "Half a unit, and less", finding: 12,
    state: { view: "operation", op: "mul", in: "q16_16", a: "0x00000001", b: "0x00008000" },
    says: `One comment says that rounding adds a whole unit, another says half a unit. The code adds half a unit, so a
      product of half a unit becomes one unit. With 0x00007fff as the second number, the product becomes 0.`,
  },
  {
    name: "Minus one, one unit too high", finding: 5,
    state: { view: "number", text: "0xffff0001", format: "q16_16" },
    says: `A macro makes constants: it scales, adds 0.5 and converts to an integer, and C truncates toward zero. So
      −1.0 becomes ffff0001, which is not −1 but the next number above it; see the column “next below”. Type -1 to see
      ffff0000, the word that the type makes.`,
  },
  {
    name: "Not an instruction of the 8088", finding: 8,
    state: {
      view: "trace", routine: "cossin", build: "i8088-printed", beside: "i8088", operands: "1", step: "differs",
    },
    says: `CosSin scales its table index with SHL BX,2, even in the code for the 8088. An 8088 shifts only by one or by
      CL, so the trace of the printed routine stops at that instruction. The other routine shifts twice by one, which
      leaves the same value in BX: step on and watch.`,
  },
  {
    name: "Not in place", finding: 9,
    state: {
      view: "trace", routine: "xformvec", build: "i386-on", beside: "none",
      operands: "0 1 0 0  1 0 0 0  0 0 1 0  1 2 3", step: "27",
    },
    says: `This transform swaps x and y, and XformVec has just stored the new x, 2. Two steps on, IMUL reads the old x
      again for the next row. If both were in one place, it would read 2 there, and (1, 2, 3) would become (2, 2, 3).`,
  },
  {
    name: "Width, or half the width", finding: 20,
    state: { view: "operation", op: "mul", in: "q16_16", a: "0xffff8000", b: "0xfec00001" },
    says: `A comment calls the ratio, −2, the distance of the projection plane divided by its width, but the code
      multiplies it by half the width. The point x = 50, z = −100 has x / z = −0.5, and −0.5 times −320 is 160 pixels:
      the edge of the screen. By the comment, the edge would be at x = 25.`,
  },
  {
    name: "SHRD in place of SHLD", finding: 13,
    state: {
      view: "trace", routine: "depth", build: "i386-loop-printed", beside: "i386-loop", operands: "1 0x1234 0",
      step: "1",
    },
    says: `The depth is 12h and 34h/256, and the loop needs 12h, its integer part, in BX. As printed, SHRD shifts EBX
      itself and puts the fraction, 3400h, into BX. SHLD does what the comment says.`,
  },
  {
    name: "A span without pixels", finding: 14,
    state: {
      view: "trace", routine: "gouraud", build: "byte-i386-loop", beside: "byte-i386-dec-jnz", operands: "0 32 1",
      step: "4",
    },
    says: `The span has no pixels, but both loops draw before they count. LOOP has decremented CX from 0 to ffffh, so
      its loop draws 65,536 pixels; DEC has decremented all of ECX, so its loop draws 4,294,967,296. The record stops
      after 1,000 instructions of each.`,
  },
  {
    name: "The odd pixel", finding: 15,
    state: {
      view: "trace", routine: "gouraud", build: "word-i386-loop", beside: "byte-i386-loop", operands: "7 32 1",
      step: "1000",
    },
    says: `The span has 7 pixels, with the intensities 20h to 26h. The loop that stores two at a time halves the count
      with SHR ECX,1, which drops the odd pixel, so it draws 6. The loop that stores bytes draws all 7.`,
  },
  {
    name: "The depth test and its description", finding: 16,
    state: { view: "trace", routine: "depth", build: "i386-loop", beside: "none", operands: "2 1 -2", step: "1000" },
    says: `The text says not to write a pixel whose depth is greater than the buffer's, and the code writes exactly
      those pixels. Over a buffer of zeros, the loop has drawn the first pixel, ff, at depth 1, but not the second
      pixel, at depth −1. By the text's rule, with a buffer that begins at minus infinity, nothing would ever be
      drawn.`,
  },
  {
    name: "A step before the fetch", finding: 21,
    state: { view: "trace", routine: "texture", build: "i386-loop", beside: "none", operands: "1 1 1 0 0", step: "5" },
    says: `The span has one pixel, from column 1 with a step of one column, and each texel of row 0 has the number of
      its column. The assembly fetches first, so it has drawn texel 1, and only now does it step to column 2. The
      pseudo-code of the same text steps first, and would draw texel 2.`,
  },
];

export const casesView = () => html`
  <h2>Famous cases</h2>
  <p>Each link opens a case in a view of this page. The numbers of the findings are those of docs/findings.md.</p>
  <div class="cases">${cases.map(({ name, finding, state, says }) => html`
    <article><h3><a href=${hashOf(state)}>${name}</a> <small>finding ${finding}</small></h3>
      <p>${says}</p></article>`)}
  </div>`;
