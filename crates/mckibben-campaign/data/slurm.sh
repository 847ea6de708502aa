#!/bin/sh
#SBATCH --job-name=@NAME@
#SBATCH --cpus-per-task=1
#SBATCH --time=@MINUTES@
# Add here what your site needs: --partition, --account, --mem-per-cpu, module load.
# With an index the script computes a share, without one it merges the parts.
if [ -n "$SLURM_ARRAY_TASK_ID" ]; then
    exec @PROGRAM@ campaign @PLAN@ -o @FOLDER@ --shard "$SLURM_ARRAY_TASK_ID/@SHARDS@" --threads 1 --yes --quiet
fi
exec @PROGRAM@ campaign merge @FOLDER@ -o @MERGED@
