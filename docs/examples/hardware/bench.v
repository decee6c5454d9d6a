// Reads the cases of `fixproof gen` on standard input and writes one result a line, for Icarus
// Verilog and Verilator. DIVIDE chooses the divider, DEFECT a defect.
module bench;
  parameter DIVIDE = 0;
  parameter DEFECT = 0;
  localparam LATENCY = 2;

  reg clock = 1'b0;
  reg start = 1'b0;
  reg signed [31:0] a;
  reg signed [31:0] b;
  wire signed [31:0] product;
  wire signed [31:0] quotient;
  wire done;
  wire error;
  integer read = 2;
  integer given = 0;
  integer taken = 0;

  fixed_mul #(.DEFECT(DEFECT)) multiplier (
      .clock(clock), .a(a), .b(b), .result(product));
  fixed_div #(.DEFECT(DEFECT)) divider (
      .clock(clock), .start(start), .a(a), .b(b), .done(done), .error(error), .result(quotient));

  localparam STDIN = 32'h8000_0000;

  // Without $finish, which Verilator reports on standard output: without events a simulation ends.
  reg over = 1'b0;
  initial while (!over) #5 clock = !clock;

  // The operands change between two rising edges.
  always @(negedge clock) begin
    if (DIVIDE == 0) begin
      // A result belongs to the case that was given LATENCY clocks ago.
      if (given - taken == LATENCY || (read != 2 && taken < given)) begin
        $display("%08x", product);
        taken = taken + 1;
      end
      if (read == 2) read = $fscanf(STDIN, "%x %x", a, b);
      if (read == 2) given = given + 1;
      else if (taken == given) over = 1'b1;
    end else begin
      if (given > taken && done && !start) begin
        if (error) $display("DE");
        else $display("%08x", quotient);
        taken = taken + 1;
      end
      start = 1'b0;
      if (given == taken) begin
        read = $fscanf(STDIN, "%x %x", a, b);
        if (read == 2) begin
          given = given + 1;
          start = 1'b1;
        end else over = 1'b1;
      end
    end
  end
endmodule
