% plot_results FILE PICTURE draws the loops in a result.nc, and the loads of the bumps at full displacement.
%   bumpfoil cycle examples/gen1.toml -o loops
%   octave-cli --eval 'addpath examples; plot_results loops/result.nc loops.svg'
% In MATLAB: addpath examples; plot_results loops/result.nc loops.svg
function plot_results(file, picture)
  if exist('OCTAVE_VERSION', 'builtin')
    pkg load netcdf
    if ~have_window_system()
      graphics_toolkit gnuplot; % draws without a screen
    end
  end
  displacement = ncread(file, 'displacement') * 1e6; % um; increments, directions
  force = ncread(file, 'force_direct');              % N
  loads = ncread(file, 'normal_force_top_bump');     % N; bumps, increments, directions
  directions = ncread(file, 'direction');            % deg

  fig = figure('visible', 'off', 'position', [0, 0, 1000, 420]);
  subplot(1, 2, 1);
  plot(displacement, force);
  xlabel('displacement (um)');
  ylabel('force (N)');
  legend(arrayfun(@(d) sprintf('%g deg', d), directions, 'UniformOutput', false), 'location', 'northwest');

  subplot(1, 2, 2);
  [~, full] = max(displacement(:, 1));
  plot(squeeze(loads(:, full, :)), '-o', 'markersize', 3);
  xlabel('bump, counted from the weld');
  ylabel('load at full displacement (N)');
  print(fig, picture, '-dsvg');
end
