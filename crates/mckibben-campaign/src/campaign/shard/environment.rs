//! The share that an engine gives a process, by environment variables.

use super::share::Shard;
use thiserror::Error;

/// The environment variables in which an engine tells a process its index, as its documentation states them.
#[derive(Debug)]
pub struct Engine {
    /// The engine, and the kind of job.
    pub name: &'static str,
    /// Variable of the index.
    pub index: &'static str,
    /// Variable of the count; empty where there is none.
    pub count: &'static str,
    /// The first index, where no variable states it.
    pub from: u64,
    /// Variable of the first index; empty where there is none.
    pub first: &'static str,
    /// Variable of the last index; empty where there is none.
    pub last: &'static str,
    /// Variable of the step between indexes; empty where there is none.
    pub step: &'static str,
    /// The value of the index that stands for "no array".
    pub none: &'static str,
    /// Where this is documented.
    pub source: &'static str,
}

const fn engine(
    name: &'static str,
    index: &'static str,
    count: &'static str,
    from: u64,
    source: &'static str,
) -> Engine {
    Engine { name, index, count, from, first: "", last: "", step: "", none: "", source }
}

/// Every engine that `auto` understands.
pub static ENGINES: [Engine; 14] = [
    Engine {
        first: "SLURM_ARRAY_TASK_MIN",
        last: "SLURM_ARRAY_TASK_MAX",
        step: "SLURM_ARRAY_TASK_STEP",
        ..engine(
            "Slurm array",
            "SLURM_ARRAY_TASK_ID",
            "SLURM_ARRAY_TASK_COUNT",
            0,
            "slurm.schedmd.com/sbatch.html",
        )
    },
    // The count of the step and not SLURM_NTASKS, which a batch script has as well, on one process.
    engine("Slurm srun", "SLURM_PROCID", "SLURM_STEP_NUM_TASKS", 0, "slurm.schedmd.com/srun.html"),
    engine("PBS", "PBS_ARRAY_INDEX", "", 1, "OpenPBS, qsub(1B)"),
    engine("Torque", "PBS_ARRAYID", "", 1, "docs.adaptivecomputing.com/torque, multiJobSubmission"),
    Engine {
        first: "SGE_TASK_FIRST",
        last: "SGE_TASK_LAST",
        step: "SGE_TASK_STEPSIZE",
        none: "undefined",
        ..engine("Grid Engine", "SGE_TASK_ID", "", 1, "gridengine, qsub(1)")
    },
    Engine {
        last: "LSB_JOBINDEX_END",
        step: "LSB_JOBINDEX_STEP",
        none: "0",
        ..engine(
            "LSF",
            "LSB_JOBINDEX",
            "",
            1,
            "IBM Spectrum LSF 10.1, environment variables for job execution",
        )
    },
    engine("HTCondor", "_CONDOR_PROCNO", "_CONDOR_NPROCS", 0, "HTCondor manual, parallel universe"),
    engine(
        "AWS Batch",
        "AWS_BATCH_JOB_ARRAY_INDEX",
        "AWS_BATCH_JOB_ARRAY_SIZE",
        0,
        "docs.aws.amazon.com/batch, job_env_vars",
    ),
    engine(
        "AWS Batch nodes",
        "AWS_BATCH_JOB_NODE_INDEX",
        "AWS_BATCH_JOB_NUM_NODES",
        0,
        "docs.aws.amazon.com/batch, mnp-env-vars",
    ),
    engine("Kubernetes", "JOB_COMPLETION_INDEX", "", 0, "kubernetes.io, Indexed Job"),
    engine("HyperQueue", "HQ_TASK_ID", "", 1, "it4innovations.github.io/hyperqueue, task arrays"),
    engine(
        "Open MPI",
        "OMPI_COMM_WORLD_RANK",
        "OMPI_COMM_WORLD_SIZE",
        0,
        "docs.open-mpi.org, environment variables",
    ),
    engine("PMI", "PMI_RANK", "PMI_SIZE", 0, "MPICH, process management interface"),
    engine("PMIx", "PMIX_RANK", "", 0, "pmix.github.io, PMIx standard"),
];

/// Why the environment names no share.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum ShardError {
    /// No variable of any engine.
    #[error("`shard` is auto, and no engine has set its variables ({})", ENGINES.iter().map(|e| e.index).collect::<Vec<_>>().join(", "))]
    None,
    /// An index without a count.
    #[error("{engine} gives an index ({variable}) and no count")]
    NoCount {
        /// The engine.
        engine: &'static str,
        /// Variable of the index.
        variable: &'static str,
    },
    /// A variable that is not a whole number, or not there.
    #[error("{variable} is \"{value}\", which is not a whole number")]
    NotANumber {
        /// The variable.
        variable: &'static str,
        /// Its value.
        value: String,
    },
    /// An index below the first or beyond the last.
    #[error("{variable} is {value}, outside of {first} to {last}")]
    Outside {
        /// The variable.
        variable: &'static str,
        /// Its value.
        value: u64,
        /// The first index.
        first: u64,
        /// The last index.
        last: u64,
    },
    /// An array with gaps.
    #[error(
        "the array has {count} indexes between {first} and {last}, so that its index ({variable}) does not state a share"
    )]
    Gaps {
        /// Variable of the index.
        variable: &'static str,
        /// Number of indexes.
        count: u64,
        /// The first.
        first: u64,
        /// The last.
        last: u64,
    },
    /// Another count than the stated one.
    #[error("`shard` is auto/{stated}, and {engine} ({variable}) has {count}")]
    OtherCount {
        /// The count of `auto/N`.
        stated: u64,
        /// The engine.
        engine: &'static str,
        /// Variable of the index.
        variable: &'static str,
        /// Its count.
        count: u64,
    },
    /// Two engines name different shares.
    #[error("{} of {} gives share {}, and {} of {} gives share {}", .one.0, .one.1, .one.2, .other.0, .other.1, .other.2)]
    Contradiction {
        /// Variable, engine and share.
        one: (&'static str, &'static str, String),
        /// Variable, engine and share.
        other: (&'static str, &'static str, String),
    },
}

impl ShardError {
    /// What can be done about it.
    pub fn hint(&self) -> &'static str {
        match self {
            Self::None => "state the share as i/n, such as 2/8",
            Self::NoCount { .. } => "state the number of shares: auto/N, such as auto/64",
            Self::NotANumber { .. } => "state the share as i/n, such as 2/8",
            Self::Outside { .. } => {
                "number the array from its first index up to the number of shares, or state the share as i/n"
            }
            Self::Gaps { .. } | Self::OtherCount { .. } => {
                "state the share with the number of all shares: i/n, such as $SLURM_ARRAY_TASK_ID/64"
            }
            Self::Contradiction { .. } => {
                "state the share as i/n, or remove the variable of one of them: env -u NAME mckibben …"
            }
        }
    }
}

/// What one engine says: its index from 0, and its count where there is one.
struct Said {
    engine: &'static Engine,
    index: u64,
    count: Option<u64>,
}

type Variable<'a> = &'a dyn Fn(&str) -> Option<String>;

fn number(variable: Variable<'_>, name: &'static str) -> Result<Option<u64>, ShardError> {
    if name.is_empty() {
        return Ok(None);
    }
    let Some(value) = variable(name) else { return Ok(None) };
    let number = value.trim().parse().map_err(|_| ShardError::NotANumber { variable: name, value })?;
    Ok(Some(number))
}

impl Engine {
    fn said(&'static self, variable: Variable<'_>, stated: Option<u64>) -> Result<Option<Said>, ShardError> {
        let there = variable(self.index).is_some_and(|value| !value.is_empty() && value != self.none);
        let count = if there { number(variable, self.count)? } else { None };
        // An engine that has a count states it wherever the index is a share.
        if !there || (count.is_none() && !self.count.is_empty()) {
            return Ok(None);
        }
        let value = number(variable, self.index)?.unwrap_or(self.from);
        let first = number(variable, self.first)?.unwrap_or(self.from);
        let step = number(variable, self.step)?.unwrap_or(1).max(1);
        let last = number(variable, self.last)?;
        let of_last = last.map(|last| last.saturating_sub(first) / step + 1);
        if let (Some(count), Some(last), true) = (count, last, of_last.is_some() && of_last != count) {
            return Err(ShardError::Gaps { variable: self.index, count, first, last });
        }
        let count = count.or(of_last);
        match (value.checked_sub(first).map(|beyond| beyond / step), count.or(stated)) {
            (Some(index), all) if all.is_none_or(|all| index < all) => {
                Ok(Some(Said { engine: self, index, count }))
            }
            (_, Some(all)) => {
                let last = first + (all.max(1) - 1) * step;
                Err(ShardError::Outside { variable: self.index, value, first, last })
            }
            (_, None) => Err(ShardError::NoCount { engine: self.name, variable: self.index }),
        }
    }
}

/// The share that the variables name. One of one says nothing where another engine names a share.
pub(super) fn shard(variable: Variable<'_>, stated: Option<u64>) -> Result<Shard, ShardError> {
    let mut all: Vec<Said> = vec![];
    for engine in &ENGINES {
        all.extend(engine.said(variable, stated)?);
    }
    if all.iter().any(|said| said.count != Some(1)) {
        all.retain(|said| said.count != Some(1));
    }
    let Some(first) = all.first() else { return Err(ShardError::None) };
    // The first that gives a count; those that give none are compared by their index.
    let main = all.iter().find(|said| said.count.is_some()).unwrap_or(first);
    if let Some(other) =
        all.iter().find(|s| s.index != main.index || s.count.is_some_and(|n| Some(n) != main.count))
    {
        let named = |said: &Said| {
            let count = said.count.or(stated).map_or_else(|| "?".to_owned(), |n| n.to_string());
            (said.engine.index, said.engine.name, format!("{}/{count}", said.index + 1))
        };
        return Err(ShardError::Contradiction { one: named(main), other: named(other) });
    }
    let (engine, variable) = (main.engine.name, main.engine.index);
    if let (Some(stated), Some(count)) = (stated, main.count.filter(|n| Some(*n) != stated)) {
        return Err(ShardError::OtherCount { stated, engine, variable, count });
    }
    let count = main.count.or(stated).ok_or(ShardError::NoCount { engine, variable })?;
    Shard::new(main.index + 1, count).ok_or(ShardError::NoCount { engine, variable })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::campaign::ShardChoice;

    fn of(choice: &str, variables: &[(&str, &str)]) -> Result<String, ShardError> {
        let find = |name: &str| variables.iter().find(|v| v.0 == name).map(|v| v.1.to_owned());
        choice.parse::<ShardChoice>().unwrap().shard(find).map(|shard| shard.to_string())
    }

    /// The variables as the documentation of each engine describes them for the third of four processes.
    #[test]
    fn every_engine_names_the_third_of_four() {
        let cases: [(&str, &[(&str, &str)]); 17] = [
            // sbatch --array=1-4, and --array=0-12:4
            (
                "auto",
                &[
                    ("SLURM_ARRAY_TASK_ID", "3"),
                    ("SLURM_ARRAY_TASK_COUNT", "4"),
                    ("SLURM_ARRAY_TASK_MIN", "1"),
                    ("SLURM_ARRAY_TASK_MAX", "4"),
                    ("SLURM_ARRAY_TASK_STEP", "1"),
                ],
            ),
            (
                "auto",
                &[
                    ("SLURM_ARRAY_TASK_ID", "8"),
                    ("SLURM_ARRAY_TASK_COUNT", "4"),
                    ("SLURM_ARRAY_TASK_MIN", "0"),
                    ("SLURM_ARRAY_TASK_MAX", "12"),
                    ("SLURM_ARRAY_TASK_STEP", "4"),
                ],
            ),
            // srun -n 4
            ("auto", &[("SLURM_PROCID", "2"), ("SLURM_STEP_NUM_TASKS", "4"), ("SLURM_NTASKS", "4")]),
            // qsub -J 1-4; Torque: qsub -t 1-4
            ("auto/4", &[("PBS_ARRAY_INDEX", "3")]),
            ("auto/4", &[("PBS_ARRAYID", "3")]),
            // qsub -t 1-4, and -t 10-40:10
            (
                "auto",
                &[
                    ("SGE_TASK_ID", "3"),
                    ("SGE_TASK_FIRST", "1"),
                    ("SGE_TASK_LAST", "4"),
                    ("SGE_TASK_STEPSIZE", "1"),
                ],
            ),
            (
                "auto",
                &[
                    ("SGE_TASK_ID", "30"),
                    ("SGE_TASK_FIRST", "10"),
                    ("SGE_TASK_LAST", "40"),
                    ("SGE_TASK_STEPSIZE", "10"),
                ],
            ),
            // bsub -J "name[1-4]"
            ("auto", &[("LSB_JOBINDEX", "3"), ("LSB_JOBINDEX_END", "4"), ("LSB_JOBINDEX_STEP", "1")]),
            ("auto/4", &[("LSB_JOBINDEX", "3")]),
            ("auto", &[("_CONDOR_PROCNO", "2"), ("_CONDOR_NPROCS", "4")]),
            ("auto", &[("AWS_BATCH_JOB_ARRAY_INDEX", "2"), ("AWS_BATCH_JOB_ARRAY_SIZE", "4")]),
            ("auto", &[("AWS_BATCH_JOB_NODE_INDEX", "2"), ("AWS_BATCH_JOB_NUM_NODES", "4")]),
            ("auto/4", &[("JOB_COMPLETION_INDEX", "2")]),
            ("auto/4", &[("HQ_TASK_ID", "3")]),
            ("auto", &[("OMPI_COMM_WORLD_RANK", "2"), ("OMPI_COMM_WORLD_SIZE", "4"), ("PMIX_RANK", "2")]),
            ("auto", &[("PMI_RANK", "2"), ("PMI_SIZE", "4")]),
            ("auto/4", &[("PMIX_RANK", "2")]),
        ];
        for (choice, variables) in cases {
            assert_eq!(of(choice, variables).as_deref(), Ok("3/4"), "{variables:?}");
            assert_eq!(of("auto/4", variables).as_deref(), Ok("3/4"), "{variables:?}");
        }
        for engine in &ENGINES {
            assert!(cases.iter().any(|c| c.1[0].0 == engine.index), "{} has no case", engine.name);
        }
    }

    #[test]
    fn what_is_no_array_says_nothing() {
        for variables in [
            &[][..],
            &[("SGE_TASK_ID", "undefined")],
            &[("LSB_JOBINDEX", "0")],
            // A batch script of four tasks is one process.
            &[("SLURM_PROCID", "0"), ("SLURM_NTASKS", "4")],
        ] {
            assert_eq!(of("auto", variables), Err(ShardError::None), "{variables:?}");
        }
        // One process in each element of an array.
        let array = [
            ("AWS_BATCH_JOB_ARRAY_INDEX", "5"),
            ("AWS_BATCH_JOB_ARRAY_SIZE", "8"),
            ("PMI_RANK", "0"),
            ("PMI_SIZE", "1"),
        ];
        assert_eq!(of("auto", &array).as_deref(), Ok("6/8"));
        assert_eq!(of("auto", &array[2..]).as_deref(), Ok("1/1"));
    }

    #[test]
    fn two_that_contradict_are_named() {
        let error =
            of("auto", &[("JOB_COMPLETION_INDEX", "3"), ("PMI_RANK", "1"), ("PMI_SIZE", "4")]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "PMI_RANK of PMI gives share 2/4, and JOB_COMPLETION_INDEX of Kubernetes gives share 4/?"
        );
        let error = of(
            "auto",
            &[
                ("AWS_BATCH_JOB_ARRAY_INDEX", "1"),
                ("AWS_BATCH_JOB_ARRAY_SIZE", "8"),
                ("PMI_RANK", "1"),
                ("PMI_SIZE", "4"),
            ],
        );
        assert!(matches!(error, Err(ShardError::Contradiction { .. })), "{error:?}");
        let error = of("auto/64", &[("PMI_RANK", "1"), ("PMI_SIZE", "4")]).unwrap_err();
        assert_eq!(error.to_string(), "`shard` is auto/64, and PMI (PMI_RANK) has 4");
    }

    #[test]
    fn what_states_no_share_is_refused() {
        let no_count = of("auto", &[("HQ_TASK_ID", "3")]).unwrap_err();
        assert!(
            matches!(no_count, ShardError::NoCount { variable: "HQ_TASK_ID", .. })
                && no_count.hint().contains("auto/N")
        );
        assert_eq!(
            of(
                "auto",
                &[
                    ("SLURM_ARRAY_TASK_ID", "7"),
                    ("SLURM_ARRAY_TASK_COUNT", "3"),
                    ("SLURM_ARRAY_TASK_MIN", "3"),
                    ("SLURM_ARRAY_TASK_MAX", "12")
                ]
            ),
            Err(ShardError::Gaps { variable: "SLURM_ARRAY_TASK_ID", count: 3, first: 3, last: 12 })
        );
        assert_eq!(
            of("auto/4", &[("PBS_ARRAY_INDEX", "5")]),
            Err(ShardError::Outside { variable: "PBS_ARRAY_INDEX", value: 5, first: 1, last: 4 })
        );
        assert!(matches!(
            of("auto/4", &[("PBS_ARRAY_INDEX", "0")]),
            Err(ShardError::Outside { value: 0, first: 1, .. })
        ));
        assert!(matches!(
            of("auto", &[("PMI_RANK", "4"), ("PMI_SIZE", "4")]),
            Err(ShardError::Outside { last: 3, .. })
        ));
        assert!(matches!(
            of("auto/4", &[("JOB_COMPLETION_INDEX", "-1")]),
            Err(ShardError::NotANumber { .. })
        ));
        for text in ["auto/0", "auto/", "auto8", "auto/x", "3/2"] {
            assert!(text.parse::<ShardChoice>().is_err(), "{text}");
        }
    }
}
