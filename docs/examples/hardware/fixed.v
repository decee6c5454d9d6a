// A multiplier and a divider for 16.16. DEFECT plants one in each: the multiplier loses the carry of
// its rounding at bit 32, and the divider subtracts nothing where the remainder is the divisor.

// Rounds halves up. The result comes two clocks after the operands, and a new pair may come with
// every clock.
module fixed_mul #(parameter DEFECT = 0) (
    input clock,
    input signed [31:0] a,
    input signed [31:0] b,
    output reg signed [31:0] result
);
  reg signed [63:0] product;
  wire [32:0] low = {1'b0, product[31:0]} + 33'h8000;
  wire [15:0] carry = (DEFECT != 0) ? 16'd0 : {15'd0, low[32]};

  always @(posedge clock) begin
    product <= a * b;
    result <= {product[47:32] + carry, low[31:16]};
  end
endmodule

// Rounds toward zero, one bit of the quotient each clock. `start` loads the operands, and `done`
// rises with the result, 49 clocks later. `error` tells of a zero divisor and of a quotient that does
// not fit.
module fixed_div #(parameter DEFECT = 0) (
    input clock,
    input start,
    input signed [31:0] a,
    input signed [31:0] b,
    output reg done,
    output reg error,
    output reg signed [31:0] result
);
  reg [5:0] steps;
  reg [47:0] dividend;
  reg [47:0] quotient;
  reg [31:0] divisor;
  reg [32:0] remainder;
  reg negative;
  wire [32:0] shifted = {remainder[31:0], dividend[47]};
  wire fits = shifted >= {1'b0, divisor} && !(DEFECT != 0 && shifted == {1'b0, divisor});
  wire [31:0] magnitude_a = a[31] ? -a : a;

  always @(posedge clock) begin
    if (start) begin
      steps <= 6'd48;
      dividend <= {magnitude_a, 16'd0};
      divisor <= b[31] ? -b : b;
      negative <= a[31] ^ b[31];
      remainder <= 33'd0;
      quotient <= 48'd0;
      done <= 1'b0;
    end else if (steps != 6'd0) begin
      steps <= steps - 6'd1;
      dividend <= dividend << 1;
      remainder <= fits ? shifted - {1'b0, divisor} : shifted;
      quotient <= {quotient[46:0], fits};
    end else begin
      done <= 1'b1;
      error <= divisor == 32'd0 || quotient > 48'h7fffffff + {47'd0, negative};
      result <= negative ? -quotient[31:0] : quotient[31:0];
    end
  end
endmodule
