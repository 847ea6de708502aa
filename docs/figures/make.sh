#!/bin/sh
# Makes the figures of README and docs again, with the program itself. Run from the root of the repository.
set -eu
mckibben=${MCKIBBEN:-target/release/mckibben}
"$mckibben" design --force 700N --contraction 15% --max-pressure 2.5bar --plot docs/figures/design.svg >/dev/null
"$mckibben" compare --models fe,paper,thick-wall,ideal --plot docs/figures/models.svg >/dev/null
"$mckibben" simulate examples/prototype.toml -e 0,10,20% -p 0.1,0.25 --plot docs/figures/simulate.svg >/dev/null
"$mckibben" simulate examples/prototype.toml -e 15% -p 0.25 --picture docs/figures/picture.png --show stress_hoop_mpa --cut >/dev/null
"$mckibben" rubber fit data/treloar/tension.csv --up-to 3 --plot docs/figures/rubber-treloar.svg >/dev/null
"$mckibben" rubber fit data/silicones/dragon_skin_30.csv --up-to 200% --plot docs/figures/rubber-silicone.svg >/dev/null
"$mckibben" identify examples/bench.toml --data examples/bench.csv --plot docs/figures/identify_bench.svg >/dev/null
"$mckibben" identify examples/tondu2012.toml --data data/tondu2012/static_force_20deg.csv \
    --plot docs/figures/identify_tondu2012.svg >/dev/null
"$mckibben" identify examples/festo-dmsp-20.toml --data data/martens_boblan_2017/DMSP-20-300.csv \
    --free mu,braid.angle --plot docs/figures/identify_festo.svg >/dev/null
"$mckibben" identify -D 50 --data data/paper/table1.csv --data data/paper/formula11.csv \
    --free c10=0.1,braid.stiffness=600,braid.stiffness_exponent=1 --plot docs/figures/identify_paper.svg >/dev/null
"$mckibben" simulate --model fe3d examples/prototype.toml -e 15% -p 0.25 --picture docs/figures/picture3d.png \
    --show stress_hoop_mpa --cut >/dev/null
cargo run --release --locked -q -p mckibben-cli --example peers_figure -- docs/figures/peers.svg
cargo run --quiet --release --locked -p mckibben-cli --example universal_figure -- docs/figures/universal.svg 150
