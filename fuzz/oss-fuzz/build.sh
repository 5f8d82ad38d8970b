#!/bin/bash -eu
# Builds the fuzz targets into $OUT, each with its seeds, dictionary and options: for OSS-Fuzz and, copied in by
# .clusterfuzzlite/Dockerfile, for ClusterFuzzLite. $SRC/sweep-cdt is the checkout. The toolchain is the image's default,
# a nightly one (elsewhere: RUSTUP_TOOLCHAIN=nightly), and not that of fuzz/rust-toolchain.toml.
export RUSTUP_TOOLCHAIN=${RUSTUP_TOOLCHAIN:-$(rustup default | cut -d ' ' -f 1)}
cd "$SRC/sweep-cdt/fuzz"
# The build unpacks the seeds into corpus.
cargo fuzz build
built=$(find target -type d -path '*-linux-*/release' -print -quit)

for seeds in seeds/*.hex; do
    target=$(basename "$seeds" .hex)
    cp "$built/$target" "$OUT/"
    printf '[libfuzzer]\ntimeout = 25\nentropic = 0\nuse_counters = 0\n' > "$OUT/$target.options"
    zip -q -j -r "$OUT/${target}_seed_corpus.zip" "corpus/$target"
    if [ -f "dictionaries/$target.dict" ]; then
        cp "dictionaries/$target.dict" "$OUT/"
    fi
done
