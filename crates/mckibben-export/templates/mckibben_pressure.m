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
missing = force - c{1};
root = c{2} .^ 2 + 4 * c{3} .* missing;
below = (root > 0) .* (c{2} + sqrt(max(root, 0)));
q = ones(size(e));
inside = below > 0 & 2 * missing <= below & missing > 0;
q(inside) = 2 * missing(inside) ./ below(inside);
slope = c{2} + 2 * c{3};
above = ~inside & missing > 0 & slope > 0 & missing + c{3} >= slope;
q(above) = (missing(above) + c{3}(above)) ./ slope(above);
q(missing <= 0) = 0;
status = status + 2 * above + 8 * (missing < 0 | (missing > 0 & ~inside & ~above));
pressure = q * muscle.supply;
end
