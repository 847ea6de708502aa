% LOOKUP_BLOCKS  Lookup tables of the muscle @{name} in Simulink: F(P, L), V(P, L) and P(F, L).
% @{facts}
% Run it in the folder of muscle.mat. With Simulink it makes the model mckibben_muscle with three blocks "n-D Lookup Table";
% in GNU Octave it checks the tables alone.
muscle = load('muscle.mat');
tables = {'force', muscle.pressure_pa, muscle.force_n; 'volume', muscle.pressure_pa, muscle.volume_m3; 'pressure', muscle.pull_n, muscle.pressure_of_pull_pa};
for k = 1:size(tables, 1)
    assert(isequal(size(tables{k, 3}), [numel(tables{k, 2}), numel(muscle.length_m)]));
    assert(all(isfinite(tables{k, 3}(:))) && all(diff(tables{k, 2}) > 0) && all(diff(muscle.length_m) > 0));
end
if exist('OCTAVE_VERSION', 'builtin') || ~exist('new_system', 'file')
    disp('The tables are complete; there is no Simulink here.');
else
    new_system('mckibben_muscle');
    open_system('mckibben_muscle');
    for k = 1:size(tables, 1)
        block = ['mckibben_muscle/', tables{k, 1}];
        add_block('simulink/Lookup Tables/n-D Lookup Table', block, 'Position', [60, 80 * k, 160, 80 * k + 50]);
        set_param(block, 'NumberOfTableDimensions', '2', 'Table', mat2str(tables{k, 3}, 17), ...
            'BreakpointsForDimension1', mat2str(tables{k, 2}, 17), 'BreakpointsForDimension2', mat2str(muscle.length_m, 17), ...
            'InterpMethod', 'Linear point-slope', 'ExtrapMethod', 'Clip');
    end
    save_system('mckibben_muscle');
end
