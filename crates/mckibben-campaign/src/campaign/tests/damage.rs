//! Cut, changed, missing and foreign files are named: recomputed by a run, refused by everything
//! else.

use super::*;
use crate::campaign::store::{
    file::{Opened, part as encode},
    folder::Folder,
    layout::Layout,
    table::Table,
};

fn is_refused(path: &Path) {
    let opened = Opened::file(path).map(drop);
    assert!(
        matches!(opened, Err(CampaignError::Damaged { .. })),
        "{opened:?}"
    );
}

/// The bytes with one bit flipped, at a place that a seed draws.
fn flipped(whole: &[u8], seed: &mut u64) -> Vec<u8> {
    // Knuth's MMIX.
    *seed = seed
        .wrapping_mul(6364136223846793005)
        .wrapping_add(1442695040888963407);
    let bit = (*seed >> 20) as usize % (8 * whole.len());
    let mut changed = whole.to_vec();
    changed[bit / 8] ^= 1 << (bit % 8);
    changed
}

/// How often each is tried: `FLIPS=1000 cargo test` for a long count.
fn flips() -> usize {
    std::env::var("FLIPS").map_or(40, |n| n.parse().unwrap())
}

/// Row A19 of the trials: of 60 flipped bits 55 were merged. A checksum of all bytes sees every one.
#[test]
fn every_flipped_bit_of_a_table_is_refused_by_name() {
    let dir = folder();
    let path = dir.path().join("c.parquet");
    run_to(&path);
    let whole = bytes(&path);
    let other = dir.path().join("other.parquet");
    let mut seed = 19;
    for _ in 0..flips() {
        std::fs::write(&other, flipped(&whole, &mut seed)).unwrap();
        is_refused(&other);
        for error in [
            read(&other).unwrap_err(),
            summary(&other).unwrap_err(),
            run(&plan(), &other, &RunOptions::default(), &Silent).unwrap_err(),
        ] {
            assert!(error.to_string().contains("other.parquet is damaged"));
        }
    }
}

/// The same row: `b[len(b) // 3] ^= 64` and others; the next run of the shard computes the part again.
#[test]
fn every_flipped_bit_of_a_part_is_refused_and_its_shard_computes_it_again() {
    let dir = folder();
    let expected = reference(&dir);
    let store = dir.path().join("store");
    let merged = dir.path().join("merged.parquet");
    run_to(&store);
    let place = part(&store, 3);
    let whole = bytes(&place);
    let mut third = whole.clone();
    third[whole.len() / 3] ^= 64;
    let mut seed = 20;
    let drawn = (0..flips()).map(|_| flipped(&whole, &mut seed));
    for (i, changed) in std::iter::once(third).chain(drawn).enumerate() {
        std::fs::write(&place, &changed).unwrap();
        let error = merge(std::slice::from_ref(&store), &merged, true).unwrap_err();
        assert!(error.to_string().contains("part-000003.parquet"), "{error}");
        assert!(read(&store).is_err());
        assert_eq!(summary(&store).unwrap().damaged.len(), 1);
        // Parts that are looked at by every shard cost time.
        if i < 10 {
            let outcome = run(&plan(), &store, &share("4/12"), &Silent).unwrap();
            assert_eq!(outcome.recomputed.len(), 1);
            merge(std::slice::from_ref(&store), &merged, true).unwrap();
            assert!(bytes(&merged) == expected);
        }
    }
}

#[test]
fn a_cut_file_is_refused() {
    let dir = folder();
    let path = dir.path().join("c.parquet");
    run_to(&path);
    let whole = bytes(&path);
    let other = dir.path().join("other.parquet");
    for length in (0..whole.len()).step_by(101) {
        std::fs::write(&other, &whole[..length]).unwrap();
        is_refused(&other);
    }
    // As file systems leave it after a power cut: the length is right, the end is empty.
    let mut zeros = whole.clone();
    zeros[2000..].fill(0);
    std::fs::write(&other, &zeros).unwrap();
    is_refused(&other);
}

#[test]
fn a_run_recomputes_damaged_parts_and_names_them() {
    let dir = folder();
    let expected = reference(&dir);
    let store = dir.path().join("store");
    run_to(&store);
    let whole = bytes(&part(&store, 5));
    std::fs::write(part(&store, 5), &whole[..whole.len() / 2]).unwrap();
    std::fs::write(part(&store, 7), b"").unwrap();
    std::fs::write(part(&store, 8), b"PAR1hello").unwrap();
    // The header of its first page.
    let mut page = bytes(&part(&store, 9));
    page[4..12].fill(0xff);
    std::fs::write(part(&store, 9), page).unwrap();
    // The name says otherwise.
    std::fs::copy(part(&store, 1), part(&store, 2)).unwrap();

    let merged = dir.path().join("merged.parquet");
    let error = merge(std::slice::from_ref(&store), &merged, false).unwrap_err();
    assert!(matches!(&error, CampaignError::Damaged { .. }), "{error}");
    assert!(!merged.exists(), "nothing half-written");
    assert!(read(&store).is_err());
    let shown = summary(&store).unwrap();
    assert_eq!(
        (shown.muscles, shown.missing_parts, shown.damaged.len()),
        (7, 5, 5)
    );

    let outcome = run_to(&store);
    let named: Vec<_> = outcome
        .recomputed
        .iter()
        .map(|d| d.file.file_name().unwrap().to_owned())
        .collect();
    let expected_names = [2, 5, 7, 8, 9].map(|n| part(&store, n).file_name().unwrap().to_owned());
    assert_eq!(named, expected_names);
    assert_eq!(outcome.counts.points, 5 * 6);
    merge(&[store], &merged, false).unwrap();
    assert!(bytes(&merged) == expected);
}

#[test]
fn a_shard_touches_only_its_damaged_parts() {
    let dir = folder();
    run_to(dir.path());
    std::fs::write(part(dir.path(), 4), b"").unwrap();
    std::fs::write(part(dir.path(), 5), b"").unwrap();
    let outcome = run(&plan(), dir.path(), &share("1/2"), &Silent).unwrap();
    assert_eq!(
        outcome
            .recomputed
            .iter()
            .map(|d| d.file.clone())
            .collect::<Vec<_>>(),
        [part(dir.path(), 4)]
    );
    assert_eq!(bytes(&part(dir.path(), 5)), b"");
}

#[test]
fn missing_parts_are_counted_and_named() {
    let dir = folder();
    run_to(dir.path());
    std::fs::remove_file(part(dir.path(), 2)).unwrap();
    std::fs::remove_file(part(dir.path(), 11)).unwrap();
    let error = read(dir.path()).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("2 of 12 parts are missing, the first is part-000002.parquet"),
        "{error}"
    );
    assert_eq!(summary(dir.path()).unwrap().missing_parts, 2);
    assert_eq!(run_to(dir.path()).counts.points, 12);
    assert_eq!(read(dir.path()).unwrap().len(), 72);
}

#[test]
fn another_plan_or_version_is_refused_with_a_hint() {
    let dir = folder();
    let store = dir.path().join("store");
    let file = dir.path().join("c.parquet");
    run_to(&store);
    run_to(&file);
    let before = (bytes(&part(&store, 0)), bytes(&file));
    let other = Plan::parse(&PLAN.replace("seed = 2", "seed = 3")).unwrap();
    for out in [&store, &file] {
        let error = run(&other, out, &RunOptions::default(), &Silent).unwrap_err();
        assert!(matches!(error, CampaignError::OtherPlan { .. }), "{error}");
        assert!(error.hint().contains("write to another place"));
    }
    assert!(
        before == (bytes(&part(&store, 0)), bytes(&file)),
        "both are as they were"
    );

    let older = Provenance {
        version: "0.0.9".into(),
        ..Provenance::for_plan(&plan())
    };
    let bytes = encode(&older, 0, table_of(&plan(), 0)).unwrap();
    std::fs::write(part(&store, 0), bytes).unwrap();
    let error = run(&plan(), &store, &RunOptions::default(), &Silent).unwrap_err();
    assert!(
        error.to_string().contains("was written by mckibben 0.0.9"),
        "{error}"
    );
    // Parts of two versions make no table either.
    assert!(
        read(&store).is_err() && merge(&[store], &dir.path().join("m.parquet"), false).is_err()
    );
}

fn table_of(plan: &Plan, muscle: u64) -> Table {
    let mut table = Table::new(Layout::for_plan(plan).fields());
    crate::campaign::solve::rows(plan, muscle)
        .into_iter()
        .for_each(|row| table.push(row));
    table
}

#[test]
fn parts_that_claim_the_same_and_differ_are_a_conflict() {
    let dir = folder();
    let one = dir.path().join("one");
    let other = dir.path().join("other");
    run_to(&one);
    std::fs::create_dir(&other).unwrap();
    // The rows of muscle 4 under the name of muscle 3.
    let forged = encode(&Provenance::for_plan(&plan()), 3, table_of(&plan(), 4)).unwrap();
    std::fs::write(part(&other, 3), forged).unwrap();
    assert_eq!(Opened::file(&part(&other, 3)).unwrap().part, Some(3));
    let error = merge(&[one, other], &dir.path().join("m.parquet"), false).unwrap_err();
    assert!(matches!(error, CampaignError::Conflict { .. }), "{error}");
}

#[test]
fn what_is_no_campaign_is_not_read_and_not_overwritten() {
    let dir = folder();
    let file = dir.path().join("table.parquet");
    for content in [
        &b""[..],
        b"PAR1",
        b"PAR1PAR1",
        b"outer_diameter_mm,wall_mm\n30,3\n",
        &[0; 5000],
    ] {
        std::fs::write(&file, content).unwrap();
        assert!(read(&file).is_err() && summary(&file).is_err());
        assert!(run(&plan(), &file, &RunOptions::default(), &Silent).is_err());
        assert_eq!(bytes(&file), content);
    }
    assert!(
        matches!(read(dir.path()), Err(CampaignError::NoCampaign { .. })),
        "a folder without parts"
    );
    assert!(matches!(
        read(dir.path().join("nothing.parquet")),
        Err(CampaignError::Read { .. })
    ));
    assert!(matches!(
        merge(&[], &dir.path().join("m.parquet"), false),
        Err(CampaignError::NoCampaign { .. })
    ));
    // One part is not the table.
    let store = dir.path().join("store");
    run_to(&store);
    assert!(
        read(part(&store, 0))
            .unwrap_err()
            .to_string()
            .contains("give the folder")
    );
    // A folder where a file of another kind stands.
    let text = dir.path().join("notes.txt");
    std::fs::write(&text, "notes").unwrap();
    assert!(run(&plan(), &text, &RunOptions::default(), &Silent).is_err());
    assert_eq!(bytes(&text), b"notes");
}

#[test]
fn a_run_killed_before_it_removed_its_parts_is_tidied_up() {
    let dir = folder();
    let expected = reference(&dir);
    let file = dir.path().join("c.parquet");
    let parts = dir.path().join("c.parquet.parts");
    run_to(&parts);
    std::fs::write(&file, &expected).unwrap();
    let outcome = run_to(&file);
    assert_eq!(
        (outcome.complete, outcome.counts.points, parts.exists()),
        (true, 0, false)
    );
    // A part under the file's name is not the table.
    run_to(&parts);
    std::fs::copy(part(&parts, 0), &file).unwrap();
    assert!(run(&plan(), &file, &RunOptions::default(), &Silent).is_err());
}

#[test]
fn what_a_killed_run_or_merge_left_unfinished_is_swept_away() {
    let dir = folder();
    let left = dir.path().join(".unfinished-abc");
    std::fs::write(&left, b"PAR1").unwrap();
    run_to(dir.path());
    assert!(!left.exists());
    assert_eq!(read(dir.path()).unwrap().len(), 72);
    let left = dir.path().join(".unfinished-m.parquet-k1ll3d");
    let merged = dir.path().join("m.parquet");
    std::fs::write(&left, b"PAR1").unwrap();
    merge(&[dir.path().into()], &merged, false).unwrap();
    assert!(!left.exists());
}

fn replacing() -> RunOptions {
    RunOptions {
        overwrite: true,
        ..RunOptions::default()
    }
}

/// A Parquet file of something else: groups in groups, and more rows in a group than ours have.
fn foreign_parquet() -> Vec<u8> {
    use parquet::{column::writer::ColumnWriter, file::writer::SerializedFileWriter};
    let schema = "message theirs { required group g { required group h { required int32 x; } } }";
    let schema = parquet::schema::parser::parse_message_type(schema).unwrap();
    let mut out = SerializedFileWriter::new(vec![], schema.into(), Default::default()).unwrap();
    let mut group = out.next_row_group().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    let ColumnWriter::Int32ColumnWriter(writer) = column.untyped() else {
        panic!("an int32")
    };
    writer.write_batch(&[7; 100_000], None, None).unwrap();
    column.close().unwrap();
    group.close().unwrap();
    out.into_inner().unwrap()
}

#[test]
fn files_of_something_else_are_replaced_only_with_overwrite() {
    let dir = folder();
    let expected = reference(&dir);
    let theirs = foreign_parquet();
    for (out, place) in [
        ("store", "store/part-000003.parquet"),
        ("c.parquet", "c.parquet"),
    ] {
        let out = dir.path().join(out);
        let place = dir.path().join(place);
        std::fs::create_dir_all(place.parent().unwrap()).unwrap();
        std::fs::write(&place, &theirs).unwrap();
        let error = run(&plan(), &out, &RunOptions::default(), &Silent).unwrap_err();
        assert!(matches!(error, CampaignError::Foreign { .. }), "{error}");
        assert!(error.hint().contains("`overwrite`"));
        assert_eq!(bytes(&place), theirs);
        assert!(run(&plan(), &out, &replacing(), &Silent).unwrap().complete);
        assert_eq!(read(&out).unwrap().len(), 72);
        let _ = (std::fs::remove_dir_all(&out), std::fs::remove_file(&out));
    }
    // A table that is merged into a file of theirs.
    let parts = dir.path().join("parts");
    let merged = dir.path().join("m.parquet");
    run_to(&parts);
    std::fs::write(&merged, &theirs).unwrap();
    let error = merge(std::slice::from_ref(&parts), &merged, false).unwrap_err();
    assert!(matches!(error, CampaignError::Appeared { .. }), "{error}");
    assert_eq!(bytes(&merged), theirs);
    merge(std::slice::from_ref(&parts), &merged, true).unwrap();
    assert!(bytes(&merged) == expected);
}

#[test]
fn a_campaign_of_another_plan_is_replaced_with_overwrite() {
    let dir = folder();
    let expected = reference(&dir);
    let other = Plan::parse(&PLAN.replace("samples = 12", "samples = 20")).unwrap();
    let store = dir.path().join("store");
    let file = dir.path().join("c.parquet");
    for out in [&store, &file] {
        run(&other, out, &RunOptions::default(), &Silent).unwrap();
        assert!(run(&plan(), out, &replacing(), &Silent).unwrap().complete);
    }
    assert!(bytes(&file) == expected);
    assert_eq!(
        Folder::parts(&store).unwrap().len(),
        12,
        "the parts beyond this plan are gone"
    );
    // Nothing to be done is nothing replaced.
    assert_eq!(
        run(&plan(), &file, &replacing(), &Silent)
            .unwrap()
            .counts
            .points,
        0
    );
}

/// Row A20 of the trials: a shard of plan A runs while one of plan B replaces its folder.
#[test]
fn a_plan_is_not_replaced_while_a_shard_of_it_runs() {
    let dir = folder();
    let store = dir.path().join("store");
    run(&plan(), &store, &share("1/2"), &Silent).unwrap();
    let before: Vec<Vec<u8>> = (0..12)
        .step_by(2)
        .map(|n| bytes(&part(&store, n)))
        .collect();
    let other = Plan::parse(&PLAN.replace("seed = 2", "seed = 3")).unwrap();
    let options = RunOptions {
        overwrite: true,
        ..share("2/3")
    };
    let running = Folder::for_writing(&store, Some("1/2".parse().unwrap())).unwrap();
    let error = run(&other, &store, &options, &Silent).unwrap_err();
    assert!(matches!(error, CampaignError::Locked(_)), "{error}");
    let after: Vec<Vec<u8>> = (0..12)
        .step_by(2)
        .map(|n| bytes(&part(&store, n)))
        .collect();
    assert!(before == after);
    drop(running);
    // Row B41: what is replaced was not damaged.
    let outcome = run(&other, &store, &options, &Silent).unwrap();
    assert!(outcome.recomputed.is_empty());
    assert_eq!(Folder::parts(&store).unwrap().len(), 4);
    let error = run(&plan(), &store, &share("1/2"), &Silent).unwrap_err();
    assert!(matches!(error, CampaignError::OtherPlan(_)), "{error}");
}

/// Row B39 of the trials: a folder was called complete that `merge` refuses.
#[test]
fn the_summary_names_parts_of_another_plan() {
    let dir = folder();
    let store = dir.path().join("store");
    run_to(&store);
    let other = Plan::parse(&PLAN.replace("seed = 2", "seed = 3")).unwrap();
    let forged = encode(&Provenance::for_plan(&other), 5, table_of(&other, 5)).unwrap();
    std::fs::write(part(&store, 5), forged).unwrap();
    std::fs::copy(part(&store, 1), part(&store, 2)).unwrap();
    let seen = summary(&store).unwrap();
    assert_eq!((seen.complete, seen.missing_parts), (false, 2));
    let [shard] = &seen.shards[..] else {
        panic!("{:?}", seen.shards)
    };
    assert_eq!((shard.state, shard.parts), (ShardState::Missing, 10));
    for (said, number) in seen.damaged.iter().zip([2, 5]) {
        assert!(
            said.contains(&part(&store, number).display().to_string()),
            "{said}"
        );
    }
    assert_eq!(seen.damaged.len(), 2);
}

/// Row B40 of the trials: a misspelt folder was made, with those above it.
#[test]
fn a_folder_in_a_folder_that_does_not_exist_is_refused() {
    let dir = folder();
    for name in ["misspelt/parts", "misspelt/c.parquet"] {
        let out = dir.path().join(name);
        let error = run(&plan(), &out, &RunOptions::default(), &Silent).unwrap_err();
        assert!(
            error.to_string().ends_with("misspelt does not exist"),
            "{error}"
        );
        assert!(!dir.path().join("misspelt").exists());
    }
}

/// Puts a file there while the campaign runs.
struct Puts<'a>(&'a Path);

impl Progress for Puts<'_> {
    fn report(&self, _: usize, _: usize) {
        std::fs::write(self.0, b"theirs").unwrap();
    }
}

#[test]
fn a_file_that_comes_during_a_run_stays_and_the_work_is_kept() {
    let dir = folder();
    let expected = reference(&dir);
    let file = dir.path().join("c.parquet");
    let error = run(&plan(), &file, &RunOptions::default(), &Puts(&file)).unwrap_err();
    assert!(matches!(error, CampaignError::Appeared { .. }), "{error}");
    assert_eq!(bytes(&file), b"theirs");
    std::fs::remove_file(&file).unwrap();
    let outcome = run_to(&file);
    assert_eq!((outcome.counts.resumed, outcome.counts.points), (12, 0));
    assert!(bytes(&file) == expected);
}

#[test]
fn foreign_files_among_the_parts_of_a_finished_campaign_stay() {
    let dir = folder();
    let file = dir.path().join("c.parquet");
    let parts = dir.path().join("c.parquet.parts");
    run_to(&file);
    std::fs::create_dir(&parts).unwrap();
    std::fs::write(part(&parts, 0), foreign_parquet()).unwrap();
    std::fs::write(parts.join("notes.txt"), b"mine").unwrap();
    assert!(run_to(&file).complete);
    assert!(part(&parts, 0).exists() && parts.join("notes.txt").exists());
}

#[test]
fn numbers_that_a_file_only_claims_are_not_counted_to() {
    let dir = folder();
    let many = Provenance {
        muscles: u64::MAX,
        ..Provenance::for_plan(&plan())
    };
    std::fs::write(
        part(dir.path(), 0),
        encode(&many, 0, table_of(&plan(), 0)).unwrap(),
    )
    .unwrap();
    let error = read(dir.path()).unwrap_err().to_string();
    assert!(
        error.contains("18446744073709551614 of 18446744073709551615 parts are missing"),
        "{error}"
    );
    assert_eq!(summary(dir.path()).unwrap().missing_parts, u64::MAX - 1);
}
