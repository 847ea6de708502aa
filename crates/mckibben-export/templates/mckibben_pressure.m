function [pressure, status] = mckibben_pressure(force, length)
% MCKIBBEN_PRESSURE  Pressure in Pa at which the muscle pulls with a force in N at a length in m; closed form.
%   status: 0, or a sum of 2 above the supply, 4 contraction outside of the box, 8 no pressure gives this pull.
% @{facts}
force = force + 0 * length;
length = length + 0 * force;
[~, ~, ~, muscle] = mckibben_coefficients(0);
e = 1 - length / muscle.length;
c = mckibben_coefficients(e);
status = 4 * (e < muscle.low | e > muscle.high);
knots = [0, 0.15, 0.45, 1];
pull = c{1}; slope = c{2}; curve = zeros(size(e)); q = nan(size(e));
for k = 1:3 % between two knots the pull is of second degree in the pressure
    width = knots(k + 1) - knots(k);
    curve = curve + c{k + 2};
    missing = max(force - pull, 0);
    root = slope .^ 2 + 4 * curve .* missing;
    below = (root > 0) .* (slope + sqrt(max(root, 0)));
    here = isnan(q) & below > 0 & 2 * missing <= below * width;
    q(here) = knots(k) + 2 * missing(here) ./ below(here);
    pull = pull + width * (slope + curve * width);
    slope = slope + 2 * curve * width;
end
above = isnan(q) & slope > 0 & force >= pull;
q(above) = 1 + (force(above) - pull(above)) ./ slope(above);
none = isnan(q);
q(none) = 1;
without = force <= c{1};
q(without) = 0;
status = status + 2 * (above & ~without) + 8 * (force < c{1} | (none & ~without));
pressure = q * muscle.supply;
end
