-- Reads the cases of `fixproof gen mul` on standard input and writes one result a line. GHDL takes
-- the generic of the command line: -gdefect=true plants a defect.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity bench is
  generic (defect : boolean := false);
end entity;

architecture test of bench is
  -- Rounds halves to even. The defect rounds them up, as if the last bit were always set.
  function mul(a, b : signed(31 downto 0)) return signed is
    constant product : signed(63 downto 0) := a * b;
    constant whole   : signed(31 downto 0) := product(47 downto 16);
    constant rest    : unsigned(15 downto 0) := unsigned(product(15 downto 0));
  begin
    if rest > x"8000" or (rest = x"8000" and (defect or whole(0) = '1')) then
      return whole + 1;
    end if;
    return whole;
  end function;
begin
  process
    variable from_gen, to_check : line;
    variable a, b : std_logic_vector(31 downto 0);
    variable digit : character;
    constant digits : string(1 to 16) := "0123456789abcdef";
    variable result : unsigned(31 downto 0);
  begin
    while not endfile(input) loop
      readline(input, from_gen);
      hread(from_gen, a);
      hread(from_gen, b);
      result := unsigned(mul(signed(a), signed(b)));
      for i in 7 downto 0 loop
        digit := digits(1 + to_integer(result(4 * i + 3 downto 4 * i)));
        write(to_check, digit);
      end loop;
      writeline(output, to_check);
    end loop;
    wait;
  end process;
end architecture;
