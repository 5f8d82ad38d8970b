#!/bin/bash -eu
# Builds the fuzz targets into $OUT, each with its seeds, dictionary and options: for OSS-Fuzz and, copied in by
# .clusterfuzzlite/Dockerfile, for ClusterFuzzLite. $SRC/sweep-cdt is the checkout; the default toolchain is a
# nightly one (elsewhere: RUSTUP_TOOLCHAIN=nightly).
cd "$SRC/sweep-cdt"
# Crates of others are compiled without the counters of libFuzzer.
RUSTC_WRAPPER="$PWD/fuzz/campaigns/rustc.sh" cargo fuzz build --release --no-trace-compares
built=$(find fuzz/target -type d -path '*-linux-*/release' -print -quit)

# The program that knows the targets. The flags of the fuzzing build are not for it.
properties() {
    RUSTFLAGS='' cargo run --release --manifest-path fuzz/Cargo.toml --package sweep-cdt-properties -- "$@"
}
properties unpack fuzz/target/seeds
properties targets > fuzz/target/targets
while read -r target max_len; do
    cp "$built/$target" "$OUT/"
    printf '[libfuzzer]\nmax_len = %s\ntimeout = 25\nentropic = 0\nuse_counters = 0\n' "$max_len" \
        > "$OUT/$target.options"
    zip -q -j -r "$OUT/${target}_seed_corpus.zip" "fuzz/target/seeds/$target"
    if [ -f "fuzz/dictionaries/$target.dict" ]; then
        cp "fuzz/dictionaries/$target.dict" "$OUT/"
    fi
done < fuzz/target/targets
