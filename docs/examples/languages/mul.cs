// A 16.16 multiply in C# that rounds halves away from zero: reads cases, writes results.
using System;
using System.IO;

static class Program {
  static int Mul(int a, int b) {
    long product = (long)a * b;
    return unchecked((int)((product + (product < 0 ? 0x7fff : 0x8000)) >> 16));
  }

  static void Main() {
    using (var output = new StreamWriter(Console.OpenStandardOutput())) {
      for (string line; (line = Console.ReadLine()) != null;) {
        var operands = line.Split(' ');
        output.WriteLine(Mul(Convert.ToInt32(operands[0], 16), Convert.ToInt32(operands[1], 16)).ToString("x8"));
      }
    }
  }
}
