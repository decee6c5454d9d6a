# The command and the type. Unicorn lets the command run code of other processors.
class Fixproof < Formula
  desc "Judges and verifies fixed-point arithmetic, bit for bit"
  homepage "https://example.org/fixproof"
  url "https://example.org/fixproof/releases/download/v@VERSION@/fixproof-@VERSION@-source.tar.gz"
  sha256 "@SHA256@"
  license "MIT"

  depends_on "cli11" => :build
  depends_on "cmake" => :build
  depends_on "nasm" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "tinyobjloader" => :build
  depends_on "boost"
  depends_on "fmt"
  depends_on "libpng"
  depends_on "openssl@3"
  depends_on "unicorn"
  depends_on "zydis"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-D", "BUILD_TESTING=OFF", *std_cmake_args
    system "cmake", "--build", "build", "--target", "fixproof"
    system "cmake", "--install", "build"
  end

  test do
    assert_match "All parties agree on every case.", shell_output("#{bin}/fixproof verify")
  end
end
