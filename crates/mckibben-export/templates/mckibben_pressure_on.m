function [pressure, status] = mckibben_pressure_on(force, length, branch)
% MCKIBBEN_PRESSURE_ON  Pressure in Pa at which the muscle pulls with a force in N at a length in m on a branch of the hysteresis.
%   branch: -1 while it shortens, 1 while it lengthens, 0 for the mean of both. status: as of mckibben_pressure.
% @{facts}
[pressure, status] = mckibben_pressure(force, length);
if branch == 0
    return
end
[~, ~, ~, muscle] = mckibben_coefficients(0);
if branch < 0
    low = pressure; high = muscle.supply + 0 * pressure;
else
    low = mckibben_pressure(0, length) + 0 * pressure; high = pressure;
end
open = low < high;
top = high;
for k = 1:40
    middle = 0.5 * (low + high);
    q = middle / muscle.supply;
    half = muscle.friction(1) * sqrt(q) + muscle.friction(2) * q;
    under = mckibben_force(middle, length) + sign(branch) * half < force;
    low(under) = middle(under);
    high(~under) = middle(~under);
end
status(open & branch < 0 & high == top) = 8;
pressure(open) = high(open);
end
