#!/bin/bash -eu
# Builds the fuzz targets into $OUT, each with its seeds, dictionary and options: for OSS-Fuzz and, copied in by
# .clusterfuzzlite/Dockerfile, for ClusterFuzzLite. $SRC/sweep-cdt is the checkout; the default toolchain is a
# nightly one (elsewhere: RUSTUP_TOOLCHAIN=nightly).
cd "$SRC/sweep-cdt"
cargo fuzz build --no-trace-compares
built=$(find fuzz/target -type d -path '*-linux-*/release' -print -quit)
for source in fuzz/fuzz_targets/*.rs; do
    target=$(basename "$source" .rs)
    cp "$built/$target" "$OUT/"
    printf '[libfuzzer]\nmax_len = 256\ntimeout = 25\n' > "$OUT/$target.options"
    if [ -d "fuzz/seeds/$target" ]; then
        zip -q -j -r "$OUT/${target}_seed_corpus.zip" "fuzz/seeds/$target"
    fi
    if [ -f "fuzz/dictionaries/$target.dict" ]; then
        cp "fuzz/dictionaries/$target.dict" "$OUT/"
    fi
done
