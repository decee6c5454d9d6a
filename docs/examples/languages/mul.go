// A 16.16 multiply in Go that rounds halves up: reads cases, writes results.
package main

import (
	"bufio"
	"fmt"
	"os"
	"strconv"
)

func mul(a, b int32) int32 {
	return int32((int64(a)*int64(b) + 0x8000) >> 16)
}

func word(text string) int32 {
	value, _ := strconv.ParseUint(text, 16, 32)
	return int32(value)
}

func main() {
	in, out := bufio.NewScanner(os.Stdin), bufio.NewWriter(os.Stdout)
	defer out.Flush()
	for in.Scan() {
		line := in.Text()
		fmt.Fprintf(out, "%08x\n", uint32(mul(word(line[:8]), word(line[9:]))))
	}
}
