// A multiplier for q18_25, words of 43 bits, that rounds down. A case has 16 digits: the sign fills the
// 64 bits of the integer that stores a word, and so it must in the result.
module wide;
  localparam STDIN = 32'h8000_0000;
  reg signed [63:0] a;
  reg signed [63:0] b;
  reg signed [42:0] short_a;
  reg signed [42:0] short_b;
  reg signed [85:0] product;
  reg signed [42:0] result;

  initial begin
    while ($fscanf(STDIN, "%x %x", a, b) == 2) begin
      short_a = a[42:0];
      short_b = b[42:0];
      product = short_a * short_b;
      result = product[67:25];
      $display("%016x", {{21{result[42]}}, result});
    end
  end
endmodule
