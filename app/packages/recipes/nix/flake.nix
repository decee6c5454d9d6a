{
  description = "Judges and verifies fixed-point arithmetic, bit for bit";

  inputs.nixpkgs.url = "github:NixOS/nixpkgs/nixos-unstable";

  outputs = { self, nixpkgs }:
    let
      systems = [ "x86_64-linux" "aarch64-linux" ];
      each = f: nixpkgs.lib.genAttrs systems (system: f nixpkgs.legacyPackages.${system});
    in {
      packages = each (pkgs: {
        default = pkgs.stdenv.mkDerivation {
          pname = "fixproof";
          version = "@VERSION@";
          src = pkgs.fetchurl {
            url = "https://example.org/fixproof/releases/download/v@VERSION@/fixproof-@VERSION@-source.tar.gz";
            sha256 = "@SHA256@";
          };
          nativeBuildInputs = with pkgs; [ cmake ninja nasm ];
          buildInputs = with pkgs; [ boost cli11 fmt libpng nlohmann_json openssl tinyobjloader unicorn zlib zydis ];
          cmakeFlags = [ "-DBUILD_TESTING=OFF" ];
          doInstallCheck = true;
          installCheckPhase = "$out/bin/fixproof verify";
        };
      });
    };
}
