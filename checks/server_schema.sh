#!/usr/bin/env bash
# Requests made up from the OpenAPI document, right ones and wrong ones: every answer is one that the document names and describes, none
# is a 5xx, and nothing is taken that the document forbids.
#
#     bash checks/server_schema.sh [PROGRAM] [EXAMPLES] [PHASES]
set -euo pipefail
cd "$(dirname "$0")/.."
program=$(realpath "${1:-target/release/mckibben}")

folder=$(mktemp -d)
trap 'kill "$server" 2>/dev/null || true; rm -rf "$folder"' EXIT
mkfifo "$folder/address"
"$program" serve --port 0 >"$folder/address" &
server=$!
read -r address <"$folder/address"

# It keeps what it found where it runs.
cd "$folder"
python3 -m venv venv
"venv/bin/pip" install --quiet schemathesis
"venv/bin/schemathesis" run "$address/api/v1/openapi.json" \
    --checks not_a_server_error,status_code_conformance,content_type_conformance,response_schema_conformance,negative_data_rejection,unsupported_method,allow_header_conformance \
    --phases "${3:-examples,coverage,fuzzing}" --max-examples "${2:-30}" --seed 1 --request-timeout 30 \
    --suppress-health-check all
kill "$server"
wait "$server"
