#!/bin/bash -eu
# Builds the fuzz targets into $OUT, each with its seeds, dictionary and options: for OSS-Fuzz and, copied in by
# .clusterfuzzlite/Dockerfile, for ClusterFuzzLite. $SRC/sweep-cdt is the checkout; the default toolchain is a
# nightly one (elsewhere: RUSTUP_TOOLCHAIN=nightly).
cd "$SRC/sweep-cdt"
cargo fuzz build --no-trace-compares
# The seeds, a file each. The flags of the fuzzing build are not for this program.
RUSTFLAGS= cargo run --release --manifest-path fuzz/Cargo.toml --package sweep-cdt-properties -- unpack fuzz/target/seeds
built=$(find fuzz/target -type d -path '*-linux-*/release' -print -quit)
for source in fuzz/fuzz_targets/*.rs; do
    target=$(basename "$source" .rs)
    cp "$built/$target" "$OUT/"
    printf '[libfuzzer]\nmax_len = 256\ntimeout = 25\n' > "$OUT/$target.options"
    zip -q -j -r "$OUT/${target}_seed_corpus.zip" "fuzz/target/seeds/$target"
    if [ -f "fuzz/dictionaries/$target.dict" ]; then
        cp "fuzz/dictionaries/$target.dict" "$OUT/"
    fi
done
