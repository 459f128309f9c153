#!/bin/sh
# CPU time of lentray against stock POV-Ray on integral images; see compare.py.
exec python3 "$(dirname "$0")/compare.py" "$@"
